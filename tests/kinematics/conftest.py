import pytest

from workbench.kinematics import chain_engine


@pytest.fixture(params=["NumPy", "kernel"])
def implementation(request, monkeypatch):
    """What of serial chains computes, one after the other."""
    if request.param == "kernel":
        chain_engine.load_kernel()
    else:
        monkeypatch.setattr(chain_engine, "_twist_kernel", None)
        monkeypatch.setattr(chain_engine.Engine, "_is_small", lambda self, q: True)
