import pytest

from .store import KINDS, NAMES, RENEW, changed, read


@pytest.mark.parametrize(("kind", "name"), NAMES)
def test_what_happens_is_what_happened_before(kind, name):
    _, work_out = KINDS[kind]
    kept = read().get(kind, {}).get(name)
    assert kept is not None, f"{name} has no golden digests yet: {RENEW}"
    what = changed(kept, work_out(name))
    assert not what, (
        f"{name}: other {', '.join(what)} than before. If that is what you wanted, "
        f"renew the golden digests with `{RENEW}` and say so in CHANGELOG.md"
    )


def test_digests_are_kept_only_of_what_there_is():
    kept = [(kind, name) for kind, names in read().items() for name in names]
    assert sorted(kept) == sorted(NAMES), f"renew with `{RENEW}`"
