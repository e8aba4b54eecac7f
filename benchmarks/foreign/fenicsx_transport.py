#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The cycle of cycle.py in FEniCSx: Poisson, Nernst and Planck by Lagrange elements on hexahedra that are graded towards
the electrodes, SDIRK of order 2 (Alexander 1977, doi 10.1137/0714068), Newton, MUMPS; half the skin, by symmetry.

    fenicsx_transport.py LAYERS SPLIT STEPS_A_RAMP GROWTH LONGEST_S [STEPS]

LAYERS of elements through the thickness, each cell of the history split into SPLIT by SPLIT. Steps grow by GROWTH from a
ramp's length over STEPS_A_RAMP up to LONGEST_S. Prints one JSON object; STEPS ends it early, to compile."""

import json
import math
import sys

import cycle
import numpy
import ufl
from dolfinx import fem, mesh
from dolfinx.fem.petsc import NonlinearProblem
from dolfinx.nls.petsc import NewtonSolver
from mpi4py import MPI
from petsc4py import PETSc

FARADAY, GAS = 96485.33212, 8.314462618
UNIT = 1e-6  # lengths in micrometres
GRADING = 3.0  # of tanh lines through the thickness
GAMMA = 1 - 1 / math.sqrt(2)


def instants(a_ramp, growth, largest):
    """Times of the steps: they end on every time of the history, and are short behind each that bends."""
    times = [0.0, cycle.ON - cycle.RAMP]
    for begin, end in zip(cycle.TIMES[1:], cycle.TIMES[2:]):
        step, restart = cycle.RAMP / a_ramp, begin in (cycle.ON, cycle.OFF, cycle.OFF + cycle.RAMP)
        if end - begin > 2 * cycle.RAMP and not restart:
            step = min(largest, (times[-1] - times[-2]) * growth)
        while times[-1] < end - 1e-9:
            left = end - times[-1]
            ramping = end - begin < 2 * cycle.RAMP
            times.append(end if left < 1.3 * step else times[-1] + min(step, left / 2 if left < 2 * step else step))
            step = step if ramping else min(step * growth, largest)
    return times


def solver(problem):
    newton = NewtonSolver(MPI.COMM_SELF, problem)
    newton.rtol, newton.atol, newton.convergence_criterion, newton.max_it = 1e-7, 1e-10, "incremental", 12
    options, prefix = PETSc.Options(), newton.krylov_solver.getOptionsPrefix()
    for name, value in (("ksp_type", "preonly"), ("pc_type", "lu"), ("pc_factor_mat_solver_type", "mumps")):
        options[prefix + name] = value
    newton.krylov_solver.setFromOptions()
    return newton


class Transport:
    """Unknowns: concentration over that of the fixed charge, potential over RT/F."""

    def __init__(self, layers, split):
        thickness = cycle.CORE / UNIT
        size = cycle.LENGTH / UNIT, cycle.WIDTH / 2 / UNIT
        count = cycle.CELLS[0], cycle.CELLS[1] // 2
        elements = [split * count[0], split * count[1], layers]
        domain = mesh.create_box(MPI.COMM_SELF, [[0, 0, 0], [*size, 1]], elements, mesh.CellType.hexahedron)
        level = domain.geometry.x[:, 2]
        domain.geometry.x[:, 2] = thickness / 2 * (1 + numpy.tanh(GRADING * (2 * level - 1)) / math.tanh(GRADING))
        element = ufl.FiniteElement("Q", domain.ufl_cell(), 1)
        space = fem.FunctionSpace(domain, ufl.MixedElement([element, element]))
        self.now, self.before, self.rate = (fem.Function(space) for _ in range(3))
        self.patch = fem.Function(fem.FunctionSpace(domain, ("DG", 0)))
        self.step, self.carry = (fem.Constant(domain, 1.0) for _ in range(2))
        self._columns(domain, size, count)
        thermal = GAS * cycle.TEMPERATURE / FARADAY
        debye = fem.Constant(domain, cycle.PERMITTIVITY * thermal / (FARADAY * cycle.CONCENTRATION) / UNIT**2)
        diffusivity = fem.Constant(domain, cycle.DIFFUSIVITY / UNIT**2)
        concentration, potential = ufl.split(self.now)
        height = ufl.SpatialCoordinate(domain)[2] / thickness
        excess = concentration - 1 - cycle.COUPLING * cycle.through(height) * self.patch
        test, other = ufl.TestFunctions(space)
        inside = ufl.dx(metadata={"quadrature_degree": 3})
        change = (concentration - ufl.split(self.before)[0] - self.carry * ufl.split(self.rate)[0]) / self.step
        flux = ufl.grad(concentration) + concentration * ufl.grad(potential)
        form = (change * test + diffusivity * ufl.inner(flux, ufl.grad(test)) - excess * other +
                debye * ufl.inner(ufl.grad(potential), ufl.grad(other))) * inside
        walls = mesh.locate_entities_boundary(domain, 2, lambda x: numpy.isclose(x[2], 0) | numpy.isclose(x[2], thickness))
        part, _ = space.sub(1).collapse()
        zero = fem.Function(part)
        held = fem.dirichletbc(zero, fem.locate_dofs_topological((space.sub(1), part), 2, walls), space.sub(1))
        self.now.sub(0).interpolate(lambda x: numpy.ones(x.shape[1]))
        self.newton = solver(NonlinearProblem(form, self.now, bcs=[held]))
        # Of the whole skin, by Green's reciprocity: a charge at the height z induces z / h of itself at the top.
        scale = 2 * FARADAY * cycle.CONCENTRATION * UNIT**3
        self.difference = fem.form(fem.Constant(domain, -scale) * excess * (height - 0.5) * inside)
        self.unknowns = space.dofmap.index_map.size_global * space.dofmap.index_map_bs

    def _columns(self, domain, size, count):
        """Index of the column of each cell of the mesh in the history."""
        cells = domain.topology.index_map(3).size_local
        corners = domain.geometry.dofmap.array.reshape(cells, -1)
        centre = domain.geometry.x[corners].mean(axis=1)
        along, across = (numpy.minimum((centre[:, axis] / size[axis] * count[axis]).astype(int), count[axis] - 1)
                         for axis in (0, 1))
        self.column = across * cycle.CELLS[0] + along
        self.shear = cycle.cells()[2].reshape(len(cycle.TIMES), -1)

    def strain(self, time):
        after = min(max(int(numpy.searchsorted(cycle.TIMES, time)), 1), len(cycle.TIMES) - 1)
        begin, end = cycle.TIMES[after - 1:after + 1]
        share = min(max((time - begin) / (end - begin), 0), 1)
        self.patch.x.array[:] = ((1 - share) * self.shear[after - 1] + share * self.shear[after])[self.column]

    def advance(self, time, end):
        """One step; returns the iterations of Newton's method."""
        length = end - time
        self.before.x.array[:] = self.now.x.array
        self.step.value, self.carry.value = GAMMA * length, 0.0
        self.strain(time + GAMMA * length)
        first, _ = self.newton.solve(self.now)
        self.rate.x.array[:] = (self.now.x.array - self.before.x.array) / (GAMMA * length)
        self.carry.value = (1 - GAMMA) * length
        self.strain(end)
        second, _ = self.newton.solve(self.now)
        return first + second


def main(layers, split, a_ramp, growth, largest, most=None):
    transport = Transport(layers, split)
    times = instants(a_ramp, growth, largest)[:most and most + 1]
    charges, iterations = [0.0], 0
    for begin, end in zip(times, times[1:]):
        iterations += transport.advance(begin, end)
        charges.append(fem.assemble_scalar(transport.difference))
    print(json.dumps({"unknowns": transport.unknowns, "steps": len(times) - 1, "iterations": iterations,
                      "cycle": cycle.figures(times, charges)}))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:4]), *map(float, sys.argv[4:6]), *map(int, sys.argv[6:]))
