"""Functions that compute slabs (parts) of a sweep with the workers of Dask."""

from __future__ import annotations

import functools
import pickle
import sys
import sysconfig
import tempfile
import time
import types
import uuid
import warnings
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from . import _engine
from ._errors import Doubt, InputError
from ._sweep_slabs import Outcome, Slab, mixed_sets, work_on

#: Longest time for an answer of a scheduler, and for its first worker to come [s].
PATIENCE_S = 30.0
#: Slabs that the scheduler holds for each worker, so that no worker waits for its next slab.
AHEAD = 2


def _dask() -> Any:
    try:
        import distributed
    except ImportError:
        raise ImportError(
            "a sweep over several processes needs Dask, which is not installed; run " "apt install python3-dask python3-distributed"
        ) from None
    return distributed


def _security() -> Any:
    """Return new keys, so that no other user of the computer can send tasks to the workers. Without python3-cryptography, warn and return None."""
    distributed = _dask()
    try:
        return distributed.security.Security.temporary()
    except ImportError:
        words = "other users of this computer can give work to these workers; to prevent this, run apt install python3-cryptography"
        warnings.warn(words, Doubt, stacklevel=5)
        return None


@contextmanager
def local_workers(count: int, dashboard: bool) -> Iterator[Any]:
    """Yield a Dask client of new worker processes on this computer, and end the processes afterwards.

    The processes listen on the loopback interface and keep their files in a private folder.
    """
    distributed = _dask()
    import dask

    nanny: Any = distributed.Nanny

    class QuietNanny(nanny):
        """Worker that starts no dashboard of its own, although LocalCluster requests one if an address is given."""

        def __init__(self, *given: Any, **named: Any) -> None:
            super().__init__(*given, **{**named, "dashboard": False})

    # These settings suit short items. By default a worker has 50 ticks and 100 profile samples a second, and returns memory to the system after
    # each item, to request it again (a seventh of the time of an identification).
    calm: dict[str, Any] = {
        "distributed.admin.tick.interval": "500ms",
        "distributed.worker.profile.interval": "500ms",
        "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": 2**27,
        "distributed.nanny.pre-spawn-environ.MALLOC_MMAP_THRESHOLD_": 2**25,
        "distributed.worker.http.routes": [],
    }
    if not dashboard:
        calm["distributed.scheduler.http.routes"] = []
    # Each worker has an HTTP server. Without an address, this server would listen on all interfaces.
    loopback = "127.0.0.1:0"
    security = _security()
    with tempfile.TemporaryDirectory(prefix="raceway-") as private, dask.config.set(calm), distributed.LocalCluster(
        n_workers=count,
        threads_per_worker=1,
        processes=True,
        worker_class=QuietNanny,
        host="127.0.0.1",
        protocol="tcp://" if security is None else "tls://",
        security=security,
        dashboard_address=loopback,
        worker_dashboard_address=loopback,
        scheduler_kwargs={"dashboard": dashboard},
        local_directory=private,
    ) as cluster, distributed.Client(cluster) as client:
        yield client


@contextmanager
def client_of(given: Any) -> Iterator[Any]:
    """Yield the given client, or a new client of the scheduler at an address. A new client is closed afterwards."""
    distributed = _dask()
    if isinstance(given, distributed.Client):
        yield given
        return
    if not isinstance(given, str):
        raise TypeError(
            "client: must be a distributed.Client or the address of a scheduler, such as tcp://10.0.0.1:8786, " f"not {type(given).__name__}"
        )
    try:
        client = distributed.Client(given, timeout=PATIENCE_S)
    except (OSError, ValueError) as e:
        raise InputError(f"client = {given!r}: no scheduler at this address answers within {PATIENCE_S:g} s ({e})") from None
    try:
        yield client
    finally:
        client.close()


def count_workers(client: Any) -> int:
    """Return the number of workers. If there is no worker, wait for the first one."""
    try:
        client.wait_for_workers(1, timeout=PATIENCE_S)
    except TimeoutError:
        raise InputError(f"the scheduler has no worker, and no worker connected within {PATIENCE_S:g} s") from None
    return len(client.scheduler_info()["workers"])


def run_on(
    client: Any,
    function: Callable[[Any], Any],
    items: Sequence[Any],
    slabs: Sequence[Slab],
    threads: int | None,
    done: Callable[[Slab, list[Outcome]], None],
) -> None:
    """Compute `slabs` with the workers, and call `done` for each finished slab, in any order.

    If a worker process ends unexpectedly, Dask gives its slab to another worker. If a slab ends several workers, its
    items are computed one at a time. An item that ends workers gets an error in place of a value.
    """
    distributed = _dask()
    mark = uuid.uuid4().hex[:12]
    packed = _packed(function, items, function)
    waiting = deque(slabs)
    suspects: deque[tuple[Slab, int]] = deque()
    pieces: dict[Slab, dict[int, Outcome]] = {}
    flying: dict[Any, tuple[Slab, int | None]] = {}
    sets = {_engine.instruction_set()}
    alone = False  # True after the warning that no worker is left
    workers, looked = count_workers(client), time.monotonic()

    def submit(slab: Slab, at: int | None) -> None:
        part = items[slab.first : slab.last] if at is None else [items[at]]
        key = f"raceway-sweep-{mark}-{slab.number}" + ("" if at is None else f"-{at}")
        future = client.submit(_work, packed, _packed(function, items, part), threads, key=key, pure=False, retries=0)
        flying[future] = (slab, at)

    def finish_suspect(slab: Slab, at: int, outcome: Outcome) -> None:
        pieces[slab][at] = outcome
        if len(pieces[slab]) == slab.last - slab.first:
            done(slab, [outcome for _, outcome in sorted(pieces.pop(slab).items())])

    try:
        while waiting or suspects or flying:
            if time.monotonic() > looked + 1.0:
                workers, looked = len(client.scheduler_info()["workers"]), time.monotonic()
            if workers == 0 and not alone:
                alone = True
                warnings.warn("no worker is left; the sweep waits for a new worker", Doubt, stacklevel=4)
            while waiting and len(flying) < max(1, workers) * AHEAD:
                submit(waiting.popleft(), None)
            if suspects and all(at is None for _, at in flying.values()):
                submit(*suspects.popleft())
            try:
                ended = distributed.wait(list(flying), timeout=1.0, return_when="FIRST_COMPLETED").done
            except TimeoutError:
                continue
            for future in ended:
                slab, at = flying.pop(future)
                if future.status == "finished":
                    version, instruction_set, outcomes = pickle.loads(future.result())
                    _refuse_other_version(version)
                    if instruction_set not in sets:
                        sets.add(instruction_set)
                        warnings.warn(mixed_sets(sorted(sets)), Doubt, stacklevel=4)
                    if at is None:
                        done(slab, outcomes)
                    else:
                        finish_suspect(slab, at, outcomes[0])
                    continue
                if future.status != "error":
                    raise ConnectionError(
                        f"{slab}: the connection to the scheduler is lost, or the scheduler has dropped this slab ({future.status}); "
                        "with folder=, a new sweep calculates only the missing slabs"
                    )
                error = future.exception()
                if not isinstance(error, distributed.scheduler.KilledWorker):
                    raise InputError(f"{slab}: a worker cannot calculate this slab: {type(error).__name__}: {error}") from error
                if at is None:
                    pieces[slab] = {}
                    suspects.extend((slab, place) for place in range(slab.first, slab.last))
                else:
                    words = "all workers that calculated this item ended (out of memory, or a crash); see the logs of the workers"
                    finish_suspect(slab, at, Outcome(None, ("KilledWorker", words, ""), ()))
    finally:
        if flying:
            client.cancel(list(flying))


def _refuse_other_version(version: str) -> None:
    if version != _engine.__version__:
        raise InputError(f"a worker has raceway {version}, but this computer has {_engine.__version__}; install the same version on all computers")


def _work(packed: bytes, part: bytes, threads: int | None) -> bytes:
    """Compute one slab in a worker."""
    outcomes = work_on(pickle.loads(packed), pickle.loads(part), threads)
    return pickle.dumps((_engine.__version__, _engine.instruction_set(), outcomes), 5)


def _packed(function: Callable[[Any], Any], items: Sequence[Any], what: Any) -> bytes:
    """Return the pickle of a function or of items. A worker can read the pickle without the files of this script."""
    import cloudpickle

    own = _own_modules(function, items)
    for module in own:
        cloudpickle.register_pickle_by_value(module)
    try:
        return cloudpickle.dumps(what, 5)
    except Exception as e:
        raise TypeError(f"the function or an item cannot be sent to another process ({type(e).__name__}: {e})") from None
    finally:
        for module in own:
            cloudpickle.unregister_pickle_by_value(module)


def _own_modules(function: Any, items: Sequence[Any]) -> list[types.ModuleType]:
    """Return the modules of the function and of the items, without installed modules."""
    while isinstance(function, functools.partial):
        function = function.func
    names = {getattr(function, "__module__", None)} | {type(item).__module__ for item in items[:1]}
    return [sys.modules[name] for name in sorted(n for n in names if n in sys.modules) if not _installed(name)]


def _installed(name: str) -> bool:
    top = name.partition(".")[0]
    if top in ("__main__", "builtins", "raceway") or top in sys.stdlib_module_names:
        return True
    file = getattr(sys.modules[name], "__file__", None) or ""
    places = [sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), "/usr/lib/python3/dist-packages"]
    return any(file.startswith(f"{place}/") for place in places)
