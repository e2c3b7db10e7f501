# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a command line tool."""

import ctypes
import dataclasses
import os
import pathlib
import subprocess

from records import checked_record

# More than any call needs: a hang ends.
LONGEST_TIME = 60

# As <sys/prctl.h> and <linux/capability.h> have them.
PR_CAPBSET_DROP = 24
CAP_DAC_OVERRIDE = 1
CAP_DAC_READ_SEARCH = 2

C_LIBRARY = ctypes.CDLL(None)


@dataclasses.dataclass
class Result:
    command: str
    code: int
    out: str
    err: str

    def __str__(self):
        return (f"{self.command}\nexit code {self.code}\noutput: {self.out[:300]}\n"
                f"errors: {self.err[:300]}")


class Tool:
    """A program, run in a folder."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = pathlib.Path(folder)

    def command(self, *arguments):
        return [str(word) for word in (self.program, *arguments)]

    def in_folder(self, folder):
        return Tool(self.program, folder)

    def run(self, *arguments, stdout=subprocess.PIPE, **options):
        """The result, whatever it is. `options` are those of subprocess.run()."""
        command = self.command(*arguments)
        if "input" not in options:
            options.setdefault("stdin", subprocess.DEVNULL)
        done = subprocess.run(command, cwd=self.folder, stdout=stdout, stderr=subprocess.PIPE,
                              env={**os.environ, "LC_ALL": "C"}, timeout=LONGEST_TIME, check=False,
                              **options)
        out = (done.stdout or b"").decode(errors="replace")
        return Result(" ".join(command), done.returncode, out, done.stderr.decode(errors="replace"))

    def __call__(self, *arguments, **options):
        """The result of a call that must succeed."""
        result = self.run(*arguments, **options)
        assert result.code == 0, result
        return result

    def record(self, *arguments):
        """What a call that must succeed writes to the standard output as JSON, and nothing else."""
        return checked_record(self(*arguments, "--json", "-").out)

    def refuses(self, *arguments, code=1, message="", **options):
        """The result of a call that must fail, and tell why in one line after the tool's name."""
        result = self.run(*arguments, **options)
        assert result.code == code, result
        assert result.err.count("\n") == 1, f"not one line of error\n{result}"
        assert result.err.startswith(self.program.name + ": "), result
        assert message in result.err, f"the error does not say '{message}'\n{result}"
        return result


def names_in(folder):
    """All files and folders in it, in order."""
    folder = pathlib.Path(folder)
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


def obey_permissions():
    """For `preexec_fn`: the call cannot read and write everything, not even as root."""
    if os.geteuid() == 0:
        for capability in (CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH):
            if C_LIBRARY.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) != 0:
                raise OSError("root keeps its privileges")
