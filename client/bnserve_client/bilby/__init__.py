"""bnserve in bilby: its models as bilby's source model, its likelihoods as a ``bilby.Likelihood``.

::

    waveform_generator = bilby.gw.WaveformGenerator(
        ...,
        frequency_domain_source_model=bnserve_client.bilby.binary_neutron_star,
        waveform_arguments={..., "bnserve_url": "http://host:8000"},
    )

    likelihood = bnserve_client.bilby.ServiceLikelihood.from_bilby(
        interferometers, priors, waveform_arguments={..., "bnserve_url": "http://host:8000"}
    )
"""

from bnserve_client.bilby._likelihood import ServiceLikelihood
from bnserve_client.bilby._source import binary_neutron_star

__all__ = ["ServiceLikelihood", "binary_neutron_star"]
