"""Work that another thread does while the episode goes on."""

from collections.abc import Callable
from threading import Thread


class Aside:
    """One task at a time, in a thread of its own; an error comes back where one waits.

    The thread ends with its task: a process that ends waits for it, and no thread is
    left behind by recordings that are closed.
    """

    def __init__(self) -> None:
        self._thread: Thread | None = None
        self._error: BaseException | None = None

    def begin(self, task: Callable[[], None]) -> None:
        """Begins a task, once the one before is done."""
        self.wait()
        self._thread = Thread(target=self._run, args=(task,), name="household replay")
        self._thread.start()

    def wait(self) -> None:
        """Waits until nothing is left to do.

        Raises:
            BaseException: What the task raised.
        """
        if self._thread is not None:
            self._thread.join()
            self._thread = None
        if self._error is not None:
            error, self._error = self._error, None
            raise error

    def _run(self, task: Callable[[], None]) -> None:
        try:
            task()
        except BaseException as error:
            self._error = error
