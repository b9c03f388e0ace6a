"""Renews the golden digests and says which are others than before: `make golden`."""

from .store import PATH, computed, read, report, write

if __name__ == "__main__":
    before, now = read() if PATH.exists() else {}, computed()
    write(now)
    print("\n".join(report(before, now)) or "no digest has changed")
