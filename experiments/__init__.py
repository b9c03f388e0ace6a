"""The paper's experiments, studies, statistics, figures, report and command line."""
