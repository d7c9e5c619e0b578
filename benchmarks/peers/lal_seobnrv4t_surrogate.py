"""LALSimulation's SEOBNRv4T_surrogate, a peer of the paper: a surrogate of an effective-one-body model with tides.

Install:

    python3.11 -m venv $PEERS/lalsuite
    $PEERS/lalsuite/bin/pip install lalsuite==7.26

It reads SEOBNRv4T_surrogate_v2.0.0.hdf5 of lalsuite-waveform-data, which no package ships: name its folder in
LAL_DATA_PATH.
"""

from lal_approximant import main

if __name__ == "__main__":
    main("SEOBNRv4T_surrogate", "SEOBNRv4T_surrogate_v2.0.0.hdf5")
