"""Which ghost is pointed at."""

from incontext.solver.annotations import Ground
from incontext.workbench.canvas.ghosts import Ghost, Ghosts

PLUS = (100.0, 100.0)


def offered():
    ghosts = Ghosts()
    ghosts._painted = [Ghost(Ground(("v1",)), (), (PLUS,))]
    return ghosts


def test_a_plus_is_lit_from_near_and_let_go_from_afar():
    ghosts = offered()
    assert ghosts.point_at((103.0, 100.0))
    assert ghosts.lit == Ground(("v1",))
    assert not ghosts.point_at((104.0, 100.0))
    assert ghosts.point_at((140.0, 100.0))
    assert ghosts.lit is None


def test_of_a_plus_and_a_vertex_the_nearer_one_is_meant():
    ghosts = offered()
    ghosts.point_at((102.0, 100.0), [(107.0, 100.0)])
    assert ghosts.lit == Ground(("v1",))
    ghosts.point_at((105.0, 100.0), [(107.0, 100.0)])
    assert ghosts.lit is None
