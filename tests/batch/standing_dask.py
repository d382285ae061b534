"""What Dask keeps in a process and in its temporary folder for good, once it has been used."""

import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest


@pytest.fixture(scope="session", autouse=True)
def standing_dask() -> None:
    """Begins it before the first test, so that no test is said to leave it."""
    client = pytest.importorskip("distributed.client")
    utils = pytest.importorskip("distributed.utils")
    callbacks = ThreadPoolExecutor(1, thread_name_prefix="Dask-Callback-Thread")
    client.Future._cb_executor, client.Future._cb_executor_pid = callbacks, os.getpid()
    for executor in (callbacks, utils._offload_executor):
        executor.submit(bool).result()
    (Path(tempfile.gettempdir()) / "dask-scratch-space").mkdir(exist_ok=True)
