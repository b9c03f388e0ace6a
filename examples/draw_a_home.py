"""Draw a home as text, look at it, and let somebody live in it."""

from household import household_v0
from household.home.saving import save_floorplan
from household.home.sources.drawing import from_drawing
from household.scenario import PersonSpec, RobotSpec, Scenario
from household.view.floorplan_svg import draw

DRAWING = """
    +-----------------+-------------+
    |SSSSS            |       BBBBBB|
    |SSSSS       KKKKK|     s>BBBBBB|
    |  ^           ^  |       BBBBBB|
    |  r           w  :             |
    |                 :             |
    |                 |             |
    |          p      +----::::-----+
    |                               |
    |   e                        c> |
    |                               |
    +--====-------------------------+
"""

plan = from_drawing(
    DRAWING,
    name="drawn_flat",
    furniture={"S": "sofa", "K": "desk", "B": "bed"},
)
draw(plan, "drawn_flat.svg")
save_floorplan(plan, "drawn_flat.toml")  # scenarios can name this file as their home

scenario = Scenario(
    name="drawn",
    home=plan,
    people=(PersonSpec(name="ann"), PersonSpec(name="bob", persona="child")),
    robots=(RobotSpec(position=(4.0, 1.0)),),
    behaviors=("sleep", "play", "say_hello"),
)
env = household_v0.parallel_env(scenario, max_cycles=120)
observations, infos = env.reset(seed=7)
print(env.describe(observations["robot_0"]))
touches = []
while env.agents:
    env.step({"robot_0": env.behaviors.index("play")})
    touches += env.feedback("robot_0")
print(*touches, sep="\n")
