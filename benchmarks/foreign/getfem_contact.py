#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Touch and slide in GetFEM: quadratic serendipity hexahedra, the integral contact brick for a rigid obstacle with
friction, whose multiplier is that of Alart and Curnier (1991), doi 10.1016/0045-7825(91)90022-X, semi-smooth Newton, MUMPS.

    getfem_contact.py SIZE_MM CORE_ELEMENTS

Prints one JSON object."""

import json
import sys

import getfem
import numpy
import skin

TOP, BOTTOM, MIDDLE, NAFION, PLATINUM = range(1, 6)
AUGMENTATION = 1e6  # [MPa/mm] results do not depend on it, the number of iterations does
MOST_ITERATIONS = 60


def lame(young, poisson):
    return young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))


def mark(mesh):
    """Regions: faces of the top that may be touched, the held face, the symmetry plane, the materials."""
    faces, points = mesh.outer_faces(), mesh.pts()
    normals = mesh.normal_of_faces(faces)
    centres = numpy.array([points[:, mesh.pid_from_cvid(int(cell))[0]].mean(axis=1) for cell in faces[0]]).T
    near = (abs(centres[0] - skin.START - skin.SLIDE / 2) < skin.REACH + skin.SLIDE / 2) & (
        centres[1] > skin.WIDTH / 2 - skin.REACH)
    mesh.set_region(TOP, faces[:, (normals[2] > 0.5) & near])
    mesh.set_region(BOTTOM, faces[:, normals[2] < -0.5])
    mesh.set_region(MIDDLE, faces[:, normals[1] > 0.5])
    cells = mesh.cvid()
    height = numpy.array([points[2, mesh.pid_from_cvid(int(cell))[0]].mean() for cell in cells])
    core = (height > skin.ELECTRODE) & (height < skin.HEIGHT - skin.ELECTRODE)
    for region, chosen in ((NAFION, core), (PLATINUM, ~core)):
        mesh.set_region(region, numpy.vstack([cells[chosen], numpy.full(chosen.sum(), -1)]))


def build(size, core_elements):
    mesh = getfem.Mesh("cartesian", *skin.mesh_lines(size, core_elements))
    mark(mesh)
    displacement, multiplier, obstacle = getfem.MeshFem(mesh, 3), getfem.MeshFem(mesh, 3), getfem.MeshFem(mesh, 1)
    displacement.set_fem(getfem.Fem("FEM_Q2_INCOMPLETE(3)"))
    multiplier.set_fem(getfem.Fem("FEM_QK(3,1)"))
    obstacle.set_fem(getfem.Fem("FEM_QK(3,2)"))
    volume = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))  # 2 x 2 x 2 points, against locking
    surface = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(3,7)"))
    model = getfem.Model("real")
    model.add_fem_variable("u", displacement)
    model.add_filtered_fem_variable("traction", multiplier, TOP)
    for region, constants in ((NAFION, skin.NAFION), (PLATINUM, skin.PLATINUM)):
        names = f"lambda{region}", f"mu{region}"
        for name, value in zip(names, lame(*constants)):
            model.add_initialized_data(name, value)
        model.add_isotropic_linearized_elasticity_brick(volume, "u", *names, region)
    model.add_initialized_data("zero", [0.0, 0.0, 0.0])
    model.add_Dirichlet_condition_with_simplification("u", BOTTOM, "zero")
    model.add_normal_Dirichlet_condition_with_multipliers(volume, "u", 1, MIDDLE)
    model.add_initialized_fem_data("obstacle", obstacle, numpy.zeros(obstacle.nbdof()))
    model.add_initialized_fem_data("anchor", displacement, numpy.zeros(displacement.nbdof()))
    for name, value in (("r", AUGMENTATION), ("friction", skin.FRICTION), ("alpha", 1.0)):
        model.add_initialized_data(name, [value])
    model.add_integral_contact_with_rigid_obstacle_brick(surface, "u", "traction", "obstacle", "r", "friction", TOP, 1,
                                                         "alpha", "anchor")
    return model, obstacle, volume, surface


def main(size, core_elements):
    model, obstacle, volume, surface = build(size, core_elements)
    x, y, z = obstacle.basic_dof_nodes()
    shear = "2*sqrt(sqr(Sym(Grad_u)(1,2))+sqr(Sym(Grad_u)(1,3))+sqr(Sym(Grad_u)(2,3))+1e-30)"
    core = skin.LENGTH * skin.WIDTH / 2 * skin.CORE
    states, before = [], 0.0
    for indentation, travel in skin.schedule():
        # The brick takes its normal from the gradient, so the gap is given as a distance to every height z.
        gap = ((x - skin.START - travel)**2 + (y - skin.WIDTH / 2)**2) / (2 * skin.RADIUS) - indentation + skin.HEIGHT - z
        model.set_variable("obstacle", gap)
        anchor = model.variable("u").reshape(-1, 3).copy()
        anchor[:, 0] += travel - before
        model.set_variable("anchor", anchor.ravel())
        solved = model.solve("max_res", 1e-8, "max_iter", MOST_ITERATIONS, "lsolver", "mumps", "lsearch", "simplest",
                             "alpha min", 0.8)
        iterations = int(numpy.ravel(solved[0])[0])
        if iterations >= MOST_ITERATIONS:
            sys.exit(f"GetFEM: Newton gave up at indentation {indentation} mm, travel {travel} mm")
        before = travel
        force = [2 * float(getfem.asm_generic(surface, 0, f"traction({axis})", TOP, model)) for axis in (1, 3)]
        states.append({"normal_force": -force[1], "tangential_force": force[0], "iterations": iterations,
                       "mean_shear": float(getfem.asm_generic(volume, 0, shear, NAFION, model)) / core})
    print(json.dumps({"unknowns": model.nbdof(),
                      "touch": states[skin.TOUCH_STEPS - 1], "slide": states[-1]}))


if __name__ == "__main__":
    main(float(sys.argv[1]), int(sys.argv[2]))
