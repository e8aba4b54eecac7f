# SPDX-License-Identifier: Apache-2.0
"""Many runs of one case with other values: trials, engines that run them, and the folder that stores their outcomes.

An engine has the function `evaluate(case, trials, folder, on_result)` and its number of workers, `workers`: `LocalEngine` on
this machine, `ionskin.cluster.trials.ClusterEngine` on others.
"""

from .folder import StudyFolder
from .local import LocalEngine
from .trial import Outcome, Trial

__all__ = ["LocalEngine", "Outcome", "StudyFolder", "Trial"]
