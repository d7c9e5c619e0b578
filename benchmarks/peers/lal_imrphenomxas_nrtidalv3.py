"""LALSimulation's IMRPhenomXAS_NRTidalv3: the newest phenomenological model with tides.

Install:

    python3.11 -m venv $PEERS/lalsuite
    $PEERS/lalsuite/bin/pip install lalsuite==7.26
"""

from lal_approximant import main

if __name__ == "__main__":
    main("IMRPhenomXAS_NRTidalv3")
