# SPDX-License-Identifier: Apache-2.0
"""Many runs of one case with other values: trials, the engine that runs them, and the folder that keeps what they gave.

An engine has one function, `evaluate(case, trials, folder, on_result)`, and tells its number of workers: `LocalEngine` here,
`ionskin.cluster.trials.ClusterEngine` on other machines.
"""

from .folder import StudyFolder
from .local import LocalEngine
from .trial import Outcome, Trial

__all__ = ["LocalEngine", "Outcome", "StudyFolder", "Trial"]
