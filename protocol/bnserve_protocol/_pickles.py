"""Where pickles of 0.1 look for what is in another module now, for one version."""

from bnserve_protocol import _batches, _likelihood_batches, _likelihood_parameters, _model, _parameters, _results

for before, now, name in (
    (_parameters, _batches, "ParameterBatch"),
    (_likelihood_parameters, _likelihood_batches, "LikelihoodBatch"),
    (_model, _results, "RowStatus"),
):
    setattr(before, name, getattr(now, name))
