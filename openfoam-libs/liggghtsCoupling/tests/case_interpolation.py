"""The fast samplers give what OpenFOAM's own interpolation gives."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import coupled_box as box
import grainjet
from case_coupling import swarm

# distorts the box, so that faces are warped and tetrahedra differ from pyramids
DISTORTED = ("vertices ((0 0 0) (20 0 0) (20 20 0) (0 20 0) (0 0 40) (20 0 40) (20 20 40) (0 20 40));",
             "vertices ((0 0 0) (20 1 2) (22 20 -1) (0 18 2) (1 0 40) (20 -2 38) (19 20 41) (-1 21 40));")


class Interpolation(grainjet.Case):

    def fluid_at_grains(self, scheme, distorted):
        """Fluid velocity and explicit force at each grain after two steps."""
        folder = self.folder / f"{scheme}{distorted}"
        box.write(folder, steps=2, walls=True, velocity="(0.2 -0.1 1)")
        if distorted:
            path = folder / "system/blockMeshDict"
            text = path.read_text()
            self.assertIn(DISTORTED[0], text)
            path.write_text(text.replace(*DISTORTED))
        x, v = swarm(2000, 9, low=(0.002,) * 3, high=(0.018, 0.018, 0.036))
        fields = " ".join(f"f_{name}[{k}]" for name in ("fluidVelocity", "fluidExplicitForce")
                          for k in (1, 2, 3))
        box.script(folder, grains=box.grains(x, v, diameter=1e-4), boundary="f f f",
                   end=f"dump d all custom 20 grains.dump id {fields}\n"
                       'dump_modify d sort id format "%d' + 6 * " %.16g" + '"')
        box.fv_options(folder, coupling="oneWay", interpolation=scheme)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        return box.read_dump(folder / "grains.dump")

    def test_cell_point(self):
        """cellPoint against cellPointWallModified, OpenFOAM's own class, which differs only in
        cells at walls: two thirds of the grains must agree to round-off, 1e-11 of the largest value,
        on a straight mesh and on one with warped faces."""
        for distorted in (False, True):
            with self.subTest(distorted=distorted):
                ours = self.fluid_at_grains("cellPoint", distorted)
                stock = self.fluid_at_grains("cellPointWallModified", distorted)
                for columns in (range(0, 3), range(3, 6)):
                    scale = max(abs(v[k]) for v in stock.values() for k in columns)
                    self.assertGreater(scale, 0)
                    equal = [tag for tag in stock if all(
                        abs(ours[tag][k] - stock[tag][k]) < 1e-11 * scale for k in columns)]
                    self.assertGreater(len(equal), 2 / 3 * len(stock))


if __name__ == "__main__":
    unittest.main()
