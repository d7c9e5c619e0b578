"""The configuration of one server: closed, typed, passed as an argument. Nothing here reads the environment."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator, model_validator

from bnserve_protocol import Limits, nearest_name
from bnserve_protocol.wire import JSON
from bnserve_service.admission.issuers import Issuer
from bnserve_service.admission.token_files import TokenFiles, parse_toml, refuse_the_same_twice
from bnserve_service.admission.tokens import Token
from bnserve_service.errors import SettingsInvalid
from bnserve_service.guarded_files import read_text

ROW_COST = 1_000
"""Work of one row beside its samples, in samples: about 5 us against 5 ns per sample."""
FURTHER_MODE = 0.5
"""Work of every mode beside the first, in that of the first: seven are four times as much on 1,000 frequencies."""
REQUEST_COST = 10_000
"""Work of one request beside its rows, in samples: about 50 us of decoding, hand-over and packing."""

ANY_HOST = "*"
"""In ``allowed_hosts``: every host."""
_HOST = re.compile(r"\*|[A-Za-z0-9._-]{1,253}|[0-9A-Fa-f:.]{2,45}")


_ORIGIN = re.compile(r"https?://[a-z0-9._-]{1,253}(:[0-9]{1,5})?|https?://\[[0-9a-f:.]{2,45}\](:[0-9]{1,5})?")


class Settings(BaseModel):
    """Everything that can be set, with the reason for each default. Times in seconds, sizes in bytes."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    host: str = "127.0.0.1"
    """Address to listen on: this machine alone, unless told otherwise."""
    port: int = Field(default=8000, ge=0, le=65535)
    """0 takes a free port, which is printed."""
    uds: Path | None = None
    """A Unix socket instead of host and port: half the cost for samplers on the same machine."""
    allowed_hosts: tuple[str, ...] = ()
    """Names and addresses, without port, that this server is called by, beside localhost and its like: other `Host`
    headers are refused, because a web page may have made its own name point here. Empty: those of the loopback
    interface alone on a server that listens there or on a Unix socket, every host on other addresses. ``*``: every."""
    cors_origins: tuple[str, ...] = ()
    """Web pages of other sites that may ask, as browsers write their origins: `https://host` or `https://host:port`."""
    uds_mode: str | None = Field(default=None, pattern="^0?[0-7]{3}$")
    """Who may connect to the Unix socket, in the digits of `chmod`; None for what the umask leaves."""
    uds_group: str | None = None
    """The group of the Unix socket, by name or number."""
    max_connections_per_address: int | None = Field(default=None, ge=1)
    """Connections of one address at the same time, in all workers; more are closed at once. For IPv6, of one network of
    64 bits. Not for a server behind a proxy, whose address all of them have. None for no limit."""
    tls_cert: Path | None = None
    """PEM file of the server's certificate and those that lead to its authority: https instead of http. Read again when
    it changes. On a Unix socket it does not count: there, nothing travels that TLS would hide."""
    tls_key: Path | None = None
    """PEM file of the certificate's private key, without a password; None where the certificate's file has it."""
    stores: tuple[Path, ...] = ()
    """Model stores searched before the models shipped with bnserve."""
    models: tuple[str, ...] = ()
    """``name`` or ``name@version``; empty serves everything in the stores."""
    metrics_port: int | None = Field(default=None, ge=0, le=65535)
    """Serve ``/metrics`` there and not beside the waveforms."""
    metrics_host: str = "127.0.0.1"
    """Address of the metrics port, which asks for no token: only this machine reaches it unless told otherwise."""
    metrics_uds: Path | None = None
    """A Unix socket for operators instead: `/metrics` and `POST /v1/reload` are answered there and not beside the
    waveforms, without a token. `uds_mode` and `uds_group` say who may connect."""
    metrics_reload: bool = False
    """Answer `POST /v1/reload` on the metrics port, too, and not beside the waveforms; with a token of scope `admin`
    where callers need tokens."""
    metrics_tls: bool = False
    """TLS on the metrics port, too, with the certificate of `tls_cert`."""
    threads: int | None = Field(default=None, ge=1, le=1024)
    """Worker threads of each process; None takes its part of the CPU quota."""
    workers: int = Field(default=1, ge=1, le=256)
    """Worker processes; with more than one, a supervisor replaces those that die or hang."""
    tokens: tuple[Token, ...] = ()
    """Empty: no authentication, unless a file of tokens is named."""
    tokens_file: Path | None = None
    """TOML file whose `[[tokens]]` count in place of these, and are read again when it changes, at once with SIGHUP: a
    token that is taken out is not let in any more. It is the file of `--config` itself where that has tokens."""
    token_list: Path | None = None
    """File of more tokens as they are, one a line, without limits and without the scopes for operators; read again when
    it changes."""
    issuers: tuple[Issuer, ...] = ()
    """Who else may vouch for callers: OpenID providers, and issuers of SciTokens; needs the extra `oidc`."""
    access_log: bool = False
    """One line per request on standard error."""
    log_format: Literal["text", "json"] = "text"
    """For people, or one JSON object a line for programs; of a request, that has all that auditors ask for."""
    otlp_endpoint: str | None = Field(default=None, pattern="^https?://[^/?#]+[^?#]*$")
    """URL of a collector of OpenTelemetry (OTLP over HTTP, `http://127.0.0.1:4318`) that is told of requests, as spans
    of their callers' traces; needs the extra `otel`. None for nobody."""
    traces_ratio: float = Field(default=1.0, ge=0.0, le=1.0)
    """The part of requests without `traceparent` that begin a trace of their own; others follow what theirs says."""

    max_body_bytes: int = Field(default=16 * 2**20, ge=1024)
    """A full grid (8 MiB) and a full batch (320 KiB) fit twice."""
    max_json_body_bytes: int = Field(default=2 * 2**20, ge=1024)
    """JSON is for requests of curl's size: parsing numbers holds the interpreter."""
    max_json_samples: int = Field(default=2**16, ge=1)
    """Rows times frequencies of a JSON answer, about 3 MB of text."""
    max_incoming_bytes: int | None = Field(default=None, ge=1024)
    """Memory of all bodies of one worker process that are on their way or not decoded yet, beyond the first 64 KiB of
    each; None for four of the largest."""
    max_rows: int = Field(default=4096, ge=1)
    """Binaries in one request; our client divides larger batches."""
    max_frequencies: int = Field(default=2**20, ge=1)
    """Of one grid: those of 512 s up to 2048 Hz."""
    max_samples: int = Field(default=2**24, ge=1)
    """Rows times frequencies of one answer: 256 MiB of complex128 for each polarisation."""
    max_grids: int = Field(default=256, ge=1)
    """Uploaded grids that are kept; what was not used for longest goes first."""
    max_grid_bytes: int = Field(default=512 * 2**20, ge=2**20)
    """Memory of all uploaded grids together."""
    max_analysis_bytes: int = Field(default=64 * 2**20, ge=1024)
    """One uploaded analysis: three detectors on 128 s up to 2048 Hz in full take 18 MB, weights far less."""
    max_analyses: int = Field(default=256, ge=1)
    """Uploaded analyses that are kept for one owner (a token; without tokens, everybody)."""
    max_owner_analyses_bytes: int = Field(default=512 * 2**20, ge=1024)
    """Memory of the analyses of one owner: half of that of all, so that nobody takes it whole."""
    max_analyses_bytes: int = Field(default=1024 * 2**20, ge=1024)
    """Memory of the analyses of all owners together."""
    max_network_bytes: int = Field(default=4 * 2**20, ge=1024)
    """One uploaded network of detectors: four with curves of 10,000 rows take 640 KB."""
    max_networks: int = Field(default=256, ge=1)
    """Uploaded networks that are kept for one owner."""
    max_networks_bytes: int = Field(default=64 * 2**20, ge=2048)
    """Memory of the networks of all owners together, of which one may have half."""

    queue_samples: int = Field(default=2**26, ge=1)
    """Work that may wait or run, in samples: about a third of a second for one worker."""
    group_samples: int = Field(default=2**18, ge=1)
    """Requests are evaluated together up to this much work, about a millisecond."""
    max_answer_bytes: int = Field(default=2 * 2**30, ge=2**20)
    """Memory of answers being computed or not yet taken by their clients."""

    header_timeout: float = Field(default=10.0, gt=0)
    """A request line and headers have to arrive within this: longer is a client that holds connections."""
    body_timeout: float = Field(default=30.0, gt=0)
    """A body has to arrive within this: the largest analysis does at 18 Mbit/s."""
    write_timeout: float = Field(default=30.0, gt=0)
    """A client that takes nothing for this long is cut off."""
    write_rate: int = Field(default=2**19, ge=1)
    """Bytes per second at which a client has to take its answer, on the whole: one of n bytes is taken within
    write_timeout + n / write_rate, or the client is cut off. About as fast as the largest body has to come."""
    keep_alive: float = Field(default=75.0, gt=0)
    """Longer than the idle time of common client pools, so that they rarely meet a connection being closed."""
    drain_grace: float = Field(default=2.0, ge=0)
    """After SIGTERM, requests are still served for this long, so that load balancers see the ready path first: one that
    looks every second, and again after a quarter when it sees a failure, takes 1.25 s."""
    drain_timeout: float = Field(default=25.0, gt=0)
    """Then requests in flight may take this long: together below the 30 s of container platforms."""
    hung_seconds: float = Field(default=4.0, ge=1.0)
    """A worker process without a sign of life for this long is replaced; it gives two each second."""
    stuck_seconds: float = Field(default=30.0, gt=0)
    """An evaluation that takes longer will not come back: the largest takes a second or two. The server is unready
    then, and a worker process is replaced."""
    poll_seconds: float = Field(default=2.0, gt=0)
    """How often the stores are looked at for new versions and labels."""
    self_check_seconds: float = Field(default=10.0, gt=0)
    """How often a tiny evaluation is compared with its stored answer."""

    @field_validator("allowed_hosts")
    @classmethod
    def _hosts_are_bare(cls, hosts: tuple[str, ...]) -> tuple[str, ...]:
        bare = tuple(host.removeprefix("[").removesuffix("]").removesuffix(".") for host in hosts)
        wrong = [host for host in bare if not _HOST.fullmatch(host)]
        if wrong:
            raise ValueError(f"'{wrong[0]}' is not a host; write a name or an address without scheme and port")
        return bare

    @field_validator("cors_origins")
    @classmethod
    def _origins_are_exact(cls, origins: tuple[str, ...]) -> tuple[str, ...]:
        wrong = [origin for origin in origins if not _ORIGIN.fullmatch(origin)]
        if wrong:
            raise ValueError(
                f"'{wrong[0]}' is not the origin of a page; write https://host or https://host:port, without a "
                "path, in lower case. There is no * for every page: name those that may ask"
            )
        return origins

    @model_validator(mode="after")
    def _tls_is_whole(self) -> Settings:
        if self.tls_key is not None and self.tls_cert is None:
            raise ValueError("tls_key is the key of a certificate; tls_cert names its file")
        if self.metrics_tls and self.tls_cert is None:
            raise ValueError("metrics_tls needs a certificate; tls_cert names its file")
        return self

    @model_validator(mode="after")
    def _tokens_differ(self) -> Settings:
        refuse_the_same_twice(self.tokens)
        return self

    @model_validator(mode="after")
    def _one_analysis_fits(self) -> Settings:
        if not self.max_analysis_bytes <= self.max_owner_analyses_bytes <= self.max_analyses_bytes:
            raise ValueError(
                "max_analysis_bytes must not be above max_owner_analyses_bytes, nor that above max_analyses_bytes, "
                "or the largest allowed analysis could not be kept"
            )
        return self

    @model_validator(mode="after")
    def _one_network_fits(self) -> Settings:
        if 2 * self.max_network_bytes > self.max_networks_bytes:
            raise ValueError(
                "max_network_bytes must not be above half of max_networks_bytes, which is what one owner may keep"
            )
        return self

    @model_validator(mode="after")
    def _largest_body_fits(self) -> Settings:
        largest = max(self.max_body_bytes, self.max_analysis_bytes, self.max_network_bytes)
        if self.max_incoming_bytes is not None and self.max_incoming_bytes < largest:
            raise ValueError(f"max_incoming_bytes must be at least {largest}, or the largest allowed body never fits")
        return self

    @model_validator(mode="after")
    def _largest_request_fits(self) -> Settings:
        largest = self.max_samples + self.max_rows * ROW_COST + REQUEST_COST
        if self.queue_samples < largest:
            raise ValueError(f"queue_samples must be at least {largest}, or the largest allowed request never fits")
        return self

    @property
    def asks_for_tokens(self) -> bool:
        """Whether callers need one."""
        return bool(self.tokens or self.tokens_file or self.token_list or self.issuers)

    def token_files(self) -> TokenFiles:
        """Who is let in, as the files are when it is asked."""
        return TokenFiles(self.tokens, self.tokens_file, self.token_list)

    @property
    def speaks_tls(self) -> bool:
        """Whether connections are encrypted."""
        return self.tls_cert is not None and self.uds is None

    @property
    def metrics_speak_tls(self) -> bool:
        """Whether connections to the metrics port are encrypted."""
        return self.metrics_tls and self.metrics_port is not None and self.metrics_uds is None

    @property
    def reload_is_apart(self) -> bool:
        """Whether looking at the stores is asked for where the metrics are, and not beside the waveforms."""
        return self.metrics_uds is not None or (self.metrics_reload and self.metrics_port is not None)

    @property
    def incoming_bytes(self) -> int:
        """``max_incoming_bytes``, or what stands for None."""
        return self.max_incoming_bytes or 4 * max(self.max_body_bytes, self.max_analysis_bytes, self.max_network_bytes)

    def body_limit(self, media_type: str) -> int:
        """The largest body of a request for an evaluation."""
        return self.max_json_body_bytes if media_type == JSON else self.max_body_bytes

    def limits(self) -> ServiceLimits:
        """What ``/v1/limits`` says."""
        values = {name: getattr(self, name) for name in ServiceLimits.__struct_fields__}
        return ServiceLimits(**values | {"max_incoming_bytes": self.incoming_bytes})


class ServiceLimits(Limits, frozen=True, kw_only=True):
    """The limits of the protocol and those that only JSON callers and operators meet."""

    max_json_body_bytes: int
    max_json_samples: int
    queue_samples: int
    max_incoming_bytes: int


def load_settings(path: Path | None = None, overrides: Mapping[str, Any] | None = None) -> Settings:
    """Settings from a TOML file, with the values of the command line on top.

    Raises
    ------
    SettingsInvalid
        The file cannot be read, or holds an unknown key (the nearest known one is suggested) or a wrong value.
    """
    content = None if path is None else read_text(path, "settings file")
    values = {} if content is None else parse_toml(content)
    if content is not None and "tokens" in values:
        content.check_access()
        values = _with_place(values, content.path)
        if {"tokens", "token_list"} & {key for key, value in (overrides or {}).items() if value is not None}:
            del values["tokens"], values["tokens_file"]  # what the command line says counts in their place
    values |= {key: value for key, value in (overrides or {}).items() if value is not None}
    if unknown := [key for key in values if key not in Settings.model_fields]:
        raise SettingsInvalid(" ".join(_unknown_key(key) for key in unknown))
    try:
        settings = Settings.model_validate(values)
    except ValidationError as error:
        found = [(".".join(map(str, item["loc"])) or "settings", item["msg"]) for item in error.errors()]
        raise SettingsInvalid(" ".join(["Invalid settings.", *(f"{key}: {fault}." for key, fault in found)])) from error
    tokens = settings.token_files().changed()  # what is wrong with files is said now
    if settings.token_list is not None and not tokens:
        raise SettingsInvalid(f"The token file '{settings.token_list}' holds no token.")
    return settings


def _unknown_key(key: str) -> str:
    near = nearest_name(key, Settings.model_fields)
    hint = f"Known settings: {', '.join(Settings.model_fields)}." if near is None else f"Did you mean '{near}'?"
    return f"Unknown setting '{key}'. {hint}"


def _with_place(values: dict[str, Any], path: Path) -> dict[str, Any]:
    """Settings with tokens, and where these are."""
    if "tokens_file" in values:
        raise SettingsInvalid(f"Tokens are in one file: take [[tokens]] out of '{path}', or its line tokens_file.")
    return values | {"tokens_file": path.absolute()}
