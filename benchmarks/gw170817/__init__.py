"""GW170817 as the paper analysed it: three detectors, 128 s, 23 to 2000 Hz, likelihoods evaluated by a service."""
