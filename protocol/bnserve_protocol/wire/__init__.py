"""What travels, as bytes: arrays, requests, answers, problems, digests, and the memory they are read into."""

from bnserve_protocol.wire._arrays import decode_array, encode_array
from bnserve_protocol.wire._envelope import (
    JSON,
    MSGPACK,
    PROBLEM_JSON,
    WANTED_DIGEST,
    DigestName,
    Problem,
    content_digest,
    request_digest,
)
from bnserve_protocol.wire._keys import refuse_repeated_keys, unique_keys
from bnserve_protocol.wire._likelihoods import (
    LikelihoodAnswer,
    LikelihoodAnswerBody,
    LikelihoodBody,
    LikelihoodRequest,
    decode_likelihood_answer,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_answer_json,
    encode_likelihood_request,
)
from bnserve_protocol.wire._memory import ResultMemory, address_of, result_memory
from bnserve_protocol.wire._waveform_answers import WaveformAnswer, decode_answer, encode_answer, encode_answer_json
from bnserve_protocol.wire._waveforms import (
    Grid,
    GridDigest,
    OutputName,
    WaveformBody,
    WaveformRequest,
    decode_request,
    encode_request,
)

__all__ = [
    "JSON",
    "MSGPACK",
    "PROBLEM_JSON",
    "WANTED_DIGEST",
    "DigestName",
    "Grid",
    "GridDigest",
    "LikelihoodAnswer",
    "LikelihoodAnswerBody",
    "LikelihoodBody",
    "LikelihoodRequest",
    "OutputName",
    "Problem",
    "ResultMemory",
    "WaveformAnswer",
    "WaveformBody",
    "WaveformRequest",
    "address_of",
    "content_digest",
    "decode_answer",
    "decode_array",
    "decode_likelihood_answer",
    "decode_likelihood_request",
    "decode_request",
    "encode_answer",
    "encode_answer_json",
    "encode_array",
    "encode_likelihood_answer",
    "encode_likelihood_answer_json",
    "encode_likelihood_request",
    "encode_request",
    "refuse_repeated_keys",
    "request_digest",
    "result_memory",
    "unique_keys",
]
