"""Volumes of closed meshes, as OpenSCAD writes them."""


def cone(a, b, c):
    """The volume, with its sign, between a triangle and the origin."""
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6


def of_off(text):
    """Of an OFF file whose faces are convex. The counts may stand on the first line, as the newest OpenSCAD has them."""
    rows = [line.split() for line in text.splitlines()[1:] if line.strip() and not line.startswith("#")]
    head = text.split("\n", 1)[0].split()
    points, faces = map(int, (head[1:] if len(head) > 1 else rows.pop(0))[:2])
    corners = [tuple(map(float, row[:3])) for row in rows[:points]]
    volume = 0.0
    for row in rows[points:points + faces]:
        a, *others = (corners[int(i)] for i in row[1:1 + int(row[0])])
        volume += sum(cone(a, b, c) for b, c in zip(others, others[1:]))
    return volume
