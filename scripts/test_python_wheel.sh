#!/bin/bash
# Makes a source distribution of the Python module and, from that alone, a wheel. Tries the wheel where there is nothing but numpy,
# and runs its tests with Debian's modules. Everything is in build/python_wheel.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
work=$root/build/python_wheel
rm -rf "$work"
mkdir -p "$work"

/usr/bin/python3 -m venv --system-site-packages "$work/environment"
python=$work/environment/bin/python
cd "$root/python"
"$python" -c "from setuptools import build_meta; build_meta.build_sdist('$work')" > "$work/sdist.log"
rm -r protrusion_segmentation.egg-info
cd "$work"
tar xzf protrusion-segmentation-*.tar.gz
rm protrusion-segmentation-*.tar.gz
export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_BUILD_PARALLEL_LEVEL=2
"$python" -m pip wheel --no-cache-dir --no-build-isolation --no-deps --no-index --wheel-dir "$work" ./protrusion-segmentation-*/

/usr/bin/python3 -m venv "$work/empty_environment"
"$work/empty_environment/bin/pip" install --no-index --no-deps protrusion_segmentation-*.whl
ln -s /usr/lib/python3/dist-packages/numpy "$work"/empty_environment/lib/python3*/site-packages
"$work/empty_environment/bin/python" -I -c "
import protrusion_segmentation as ps
assert list(ps.segment([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])) == [0]"

"$python" -m pip install --no-index --no-deps protrusion_segmentation-*.whl
export PROTRUSION_SEGMENTATION_TOOLS=${PROTRUSION_SEGMENTATION_TOOLS-$root/build/test/tools}
"$python" -m pytest -q ./protrusion-segmentation-*/tests
"$python" -m mypy --strict "$root/python/protrusion_segmentation"
