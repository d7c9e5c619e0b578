"""LALSimulation's IMRPhenomD_NRTidalv2: a phenomenological model with tides.

Install:

    python3.11 -m venv $PEERS/lalsuite
    $PEERS/lalsuite/bin/pip install lalsuite==7.26
"""

from lal_approximant import main

if __name__ == "__main__":
    main("IMRPhenomD_NRTidalv2")
