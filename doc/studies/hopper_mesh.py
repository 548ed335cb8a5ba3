"""A mesh of half a hopper whose squares grow with the distance from its apex, in
Gmsh's format 2.2."""
import math

LINES = ("axis", "hopper", "top", "outlet", "fall_side", "fall_bottom")
SURFACES = ("material", "fall_region")


def heights(outlet, top, half_angle, columns):
    """Of the rows of nodes above the apex, from the outlet to the top."""
    tangent = math.tan(math.radians(half_angle))
    rows = round(math.log(top / outlet) / (tangent / columns))
    return [outlet / tangent * (top / outlet)**(i / rows)
            for i in range(rows + 1)]


def write_mesh(path, outlet, top, half_angle, columns):
    """Outlet and top: half widths or radii in m."""
    tangent = math.tan(math.radians(half_angle))
    above = heights(outlet, top, half_angle, columns)
    size = outlet / columns
    fall_rows = 2 * columns
    levels = ([(-size * i, outlet) for i in range(fall_rows, 0, -1)] +
              [(y - above[0], y * tangent) for y in above])
    nodes = [(width * i / columns, y) for y, width in levels
             for i in range(columns + 1)]

    def node(row, column):
        return row * (columns + 1) + column + 1
    elements = []  # type, physical group, nodes
    for row in range(len(levels) - 1):
        is_fall = row < fall_rows
        elements += [(1, "axis", (node(row, 0), node(row + 1, 0))),
                     (1, "fall_side" if is_fall else "hopper",
                      (node(row, columns), node(row + 1, columns)))]
        elements += [(3, SURFACES[is_fall],
                      (node(row, i), node(row, i + 1), node(row + 1, i + 1),
                       node(row + 1, i))) for i in range(columns)]
    for row, name in ((0, "fall_bottom"), (fall_rows, "outlet"),
                      (len(levels) - 1, "top")):
        elements += [(1, name, (node(row, i), node(row, i + 1)))
                     for i in range(columns)]
    names = LINES + SURFACES
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
            str(len(names))]
    text += [f'{1 if name in LINES else 2} {names.index(name) + 1} "{name}"'
             for name in names]
    text += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    text += [f"{i + 1} {x:.12g} {y:.12g} 0" for i, (x, y) in enumerate(nodes)]
    text += ["$EndNodes", "$Elements", str(len(elements))]
    for i, (kind, name, corners) in enumerate(elements):
        group = names.index(name) + 1
        text.append(" ".join(map(str, (i + 1, kind, 2, group, group,
                                       *corners))))
    text += ["$EndElements", ""]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(text), encoding="utf-8")
