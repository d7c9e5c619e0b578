# bnserve as a container. tests/integration/test_container.py runs these very steps without a container engine.
#
#   docker build -t bnserve .
#   docker run --rm -p 127.0.0.1:8000:8000 --read-only --tmpfs /tmp --cap-drop ALL --security-opt no-new-privileges bnserve
#
# For callers elsewhere it needs tokens: docs/guides/container.md.

# A release names the base by its digest, so that every build of it is the same:
#   docker build --build-arg BASE=python:3.12-slim@sha256:... -t bnserve .
# CONTRIBUTING.md (Releasing) says how to find it.
ARG BASE=python:3.12-slim

FROM ${BASE} AS builder
ENV PIP_DISABLE_PIP_VERSION_CHECK=1
WORKDIR /build

# What others wrote: exact versions, each file known by its hash. CONTRIBUTING.md says how to renew them.
COPY requirements.lock requirements-build.lock ./
RUN python -m venv /opt/bnserve \
    && /opt/bnserve/bin/pip install --require-hashes --only-binary=:all: -r requirements.lock
RUN python -m venv /opt/wheels \
    && /opt/wheels/bin/pip install --require-hashes --only-binary=:all: -r requirements-build.lock

# What we wrote: one wheel for each room.
COPY protocol protocol
COPY model_store model_store
COPY surrogate surrogate
COPY inference inference
COPY service service
RUN /opt/wheels/bin/pip wheel --no-deps --no-build-isolation --wheel-dir /build/wheels \
        ./protocol ./model_store ./surrogate ./inference ./service \
    && /opt/bnserve/bin/pip install --no-deps --no-index /build/wheels/*.whl \
    && /opt/bnserve/bin/pip check \
    && /opt/bnserve/bin/pip uninstall --yes pip

FROM ${BASE}
COPY --from=builder /opt/bnserve /opt/bnserve
COPY LICENSE /opt/bnserve/LICENSE

# BLAS does not see the CPU limit of a container; the service brings its own threads.
ENV OMP_NUM_THREADS=1 \
    OPENBLAS_NUM_THREADS=1 \
    MKL_NUM_THREADS=1 \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    PATH=/opt/bnserve/bin:/usr/local/bin:/usr/bin:/bin

USER 10001:10001
WORKDIR /
EXPOSE 8000
HEALTHCHECK --interval=10s --timeout=5s --start-period=60s --retries=3 \
    CMD ["/opt/bnserve/bin/python", "-c", "from urllib.request import urlopen; urlopen('http://127.0.0.1:8000/v2/health/ready', timeout=4)"]
ENTRYPOINT ["/opt/bnserve/bin/bnserve", "serve", "--host", "0.0.0.0"]
