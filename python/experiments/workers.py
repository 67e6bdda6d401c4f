# SPDX-License-Identifier: BSD-3-Clause
"""Who runs trials: the cores of this machine, or the workers of a Dask cluster."""
import concurrent.futures
import contextlib

CONNECTING = 10  # to a scheduler, at most [s]
MISSING = "no module 'distributed' for --scheduler; run scripts/install_dependencies --experiments"


class ClusterError(RuntimeError):
    """A cluster that cannot be used; the message is all that a user needs."""


@contextlib.contextmanager
def executor(jobs, scheduler=None):
    """A concurrent.futures.Executor: so many threads here, each of which waits for a program, or what the scheduler
    at an address ("tcp://HOST:PORT") has. A task of a worker that is lost is run by another one."""
    if scheduler is None:
        with concurrent.futures.ThreadPoolExecutor(jobs) as threads:
            yield threads
        return
    try:
        from distributed import Client  # only who has a cluster needs it
    except ImportError as problem:
        raise ClusterError(MISSING) from problem
    try:
        client = Client(scheduler, timeout=CONNECTING)
    except (OSError, ValueError) as problem:
        raise ClusterError(f"--scheduler {scheduler}: {problem}; is dask-scheduler running there?") from problem
    with client, client.get_executor(pure=False) as cluster:
        yield cluster
