"""Plants of Drake for comparison."""

import numpy as np
from kinematics.random_robots import random_pose


def arm_plant(links=6, seed=0):
    """A serial arm l0, l1, ... of revolute and prismatic joints with random inertias, its base on the world."""
    from pydrake.math import RigidTransform
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    rng, plant = np.random.default_rng(seed), MultibodyPlant(0.0)
    before = plant.world_body()
    for i in range(links):
        mass, com = rng.uniform(0.5, 3), rng.uniform(-0.3, 0.3, 3)
        A = rng.normal(size=(3, 3))
        S = A @ A.T + np.eye(3)
        M = mass * (np.trace(S) * np.eye(3) - S) * 0.05  # of any body: the tensor of its second moments is S
        about_com = tree.RotationalInertia(*np.diag(M), M[0, 1], M[0, 2], M[1, 2])
        central = tree.SpatialInertia.MakeFromCentralInertia(mass, com, about_com)
        body = plant.AddRigidBody(f"l{i}", central)
        F = plant.AddFrame(tree.FixedOffsetFrame(f"F{i}", before, RigidTransform(random_pose(rng))))
        kind = tree.PrismaticJoint if i % 3 == 1 else tree.RevoluteJoint
        plant.AddJoint(kind(f"j{i}", F, body.body_frame(), rng.normal(size=3)))
        before = body
    plant.Finalize()
    return plant
