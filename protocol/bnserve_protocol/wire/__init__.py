"""What travels, as bytes: arrays, requests, answers, problems, digests, and the memory they are read into."""

from bnserve_protocol.wire._arrays import (
    ResultMemory,
    address_of,
    array_keys,
    decode_array,
    encode_array,
    result_memory,
)
from bnserve_protocol.wire._bodies import (
    ForecastAnswerBody,
    ForecastBody,
    ForecastOutput,
    LikelihoodAnswerBody,
    LikelihoodBody,
    LikelihoodOutput,
    OutputName,
    WaveformBody,
)
from bnserve_protocol.wire._envelope import (
    JSON,
    MSGPACK,
    MSGPACK_BYTES,
    PROBLEM_JSON,
    WANTED_DIGEST,
    DigestName,
    Problem,
    content_digest,
    refuse_repeated_keys,
    request_digest,
    undecodable,
    unique_keys,
)
from bnserve_protocol.wire._forecasts import (
    ForecastAnswer,
    ForecastRequest,
    decode_forecast_answer,
    decode_forecast_request,
    encode_forecast_answer,
    encode_forecast_answer_json,
    encode_forecast_request,
    forecast_arrays,
    forecast_of,
)
from bnserve_protocol.wire._likelihoods import (
    LikelihoodAnswer,
    LikelihoodRequest,
    decode_likelihood_answer,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_answer_json,
    encode_likelihood_request,
)
from bnserve_protocol.wire._waveform_answers import (
    WaveformAnswer,
    decode_answer,
    derivative_names,
    encode_answer,
    encode_answer_json,
    mode_names,
)
from bnserve_protocol.wire._waveforms import Grid, GridDigest, WaveformRequest, decode_request, encode_request

__all__ = [
    "JSON", "MSGPACK", "MSGPACK_BYTES", "PROBLEM_JSON", "WANTED_DIGEST", "DigestName", "ForecastAnswer",
    "ForecastAnswerBody", "ForecastBody", "ForecastOutput", "ForecastRequest", "Grid", "GridDigest", "LikelihoodAnswer",
    "LikelihoodAnswerBody", "LikelihoodBody", "LikelihoodOutput", "LikelihoodRequest", "OutputName", "Problem",
    "ResultMemory", "WaveformAnswer", "WaveformBody", "WaveformRequest", "address_of", "array_keys", "content_digest",
    "decode_answer", "decode_array", "decode_forecast_answer", "decode_forecast_request", "decode_likelihood_answer",
    "decode_likelihood_request", "decode_request", "derivative_names", "encode_answer", "encode_answer_json",
    "encode_array", "encode_forecast_answer", "encode_forecast_answer_json", "encode_forecast_request",
    "encode_likelihood_answer", "encode_likelihood_answer_json", "encode_likelihood_request", "encode_request",
    "forecast_arrays", "forecast_of", "mode_names", "refuse_repeated_keys", "request_digest", "result_memory",
    "undecodable", "unique_keys",
]  # fmt: skip  # each has a line of its own above
