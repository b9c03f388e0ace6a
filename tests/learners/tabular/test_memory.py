from learners.tabular.memory import remember


def test_what_is_remembered_of_states_is_bounded():
    memo = {}
    for state in range(10):
        remember(memo, state, state, most=4)
        assert memo[state] == state
        assert len(memo) <= 4
