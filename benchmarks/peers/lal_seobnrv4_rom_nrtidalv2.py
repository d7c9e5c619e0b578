"""LALSimulation's SEOBNRv4_ROM_NRTidalv2, a peer of the paper: a reduced-order model of point masses, with tides added.

Install:

    python3.11 -m venv $PEERS/lalsuite
    $PEERS/lalsuite/bin/pip install lalsuite==7.26

It reads SEOBNRv4ROM_v3.0.hdf5 of lalsuite-waveform-data, which no package ships: name its folder in LAL_DATA_PATH.
"""

from lal_approximant import main

if __name__ == "__main__":
    main("SEOBNRv4_ROM_NRTidalv2", "SEOBNRv4ROM_v3.0.hdf5")
