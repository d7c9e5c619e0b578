"""Waveforms that precess, against TEOBResumS's and LALSimulation's."""
