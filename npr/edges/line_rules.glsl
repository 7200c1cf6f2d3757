// What a line is and what hides it, for an edge that npr/edges/edge_rules.glsl found. Valid in shaders and, within a
// struct with the same names, in C++.

// How often the ray of a pixel goes into an opaque part before a layer: the surfaces of a part by turns enter and leave
// it, so these are the stretches within parts that lie before, or begin before. One that holds the eye does not hide.
int solids_before(ivec2 p, int layer) {
    int solids = 0;
    for (int i = 0; i < layer; ++i) {
        uvec2 ids = surface_ids(p, i);
        if (ids.x == kNoSurface)
            break;
        if (!is_leaving(ids) && opaque(ids))
            ++solids;
    }
    return solids;
}

#include "npr/styles/remoteness.glsl"

bool made_by_section(Surface s) {
    return leaf_rows[s.leaf].part.z != 0u;
}

// How many surfaces of a pixel are before the plane of a surface that is seen at `apart` from there, and not only
// because the two meet in between.
int surfaces_before(Surface s, vec2 gradient, ivec2 p, ivec2 apart) {
    float depth = s.depth + dot(gradient, vec2(apart));
    float room = length(vec2(apart)) + 1.0f;
    int count = 0;
    for (int i = 0; i < layer_count; ++i) {
        uvec2 ids = surface_ids(p, i);
        if (ids.x == kNoSurface)
            break;
        vec2 other = depth_gradient(plane_of(ids));
        if (layer_depth(p, i) > depth + room * (length(gradient) + length(other)))
            ++count;
    }
    return count;
}

// Pixels from a line on `s` to where something nearer hides it: there more surfaces are before the plane of `s`.
float clearance_at(Surface s, int layer, ivec2 p) {
    const int reach = int(kClear);
    vec2 gradient = depth_gradient(s.plane);
    float nearest = kClear;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            ivec2 apart = ivec2(x, y);
            float far = length(vec2(apart));
            if (far < nearest && in_picture(p + apart) && surfaces_before(s, gradient, p + apart, apart) > layer)
                nearest = far;
        }
    return nearest;
}

uint kind_between(Surface s, Surface t, bool bends) {
    if (s.part != t.part)
        return kPartBorder;
    if (!bends)
        return kColorBorder;
    return s.leaf == t.leaf ? kCrease : kIntersection;
}

// The axis to which a direction is most parallel; the first of those that are about equal.
int main_axis(vec3 direction) {
    vec3 size = abs(direction);
    int axis = size.y > size.x + 1e-4f ? 1 : 0;
    return size.z > size[axis] + 1e-4f ? 2 : axis;
}

struct Anchor {
    bool found;
    float along;
    float slope;
};

// Rays through positions in the picture, counted in samples, as lines are: from a point in the world, relative to the
// planes' origin, on.
vec2 position_of(vec2 at) {
    return (at + 0.5f + jitter - 0.5f * vec2(view.picture)) * (2.0f * view.picture.z / view.picture.y);
}

vec3 ray_origin(vec2 at) {
    bool parallel = view.depth_range.z > 0.5f;
    return (vec3(parallel ? position_of(at) : vec2(0.0f), 0.0f) - center_in_eye) * mat3(view.eye_from_world);
}

vec3 ray_direction(vec2 at) {
    bool parallel = view.depth_range.z > 0.5f;
    return normalize(vec3(parallel ? vec2(0.0f) : position_of(at), -1.0f) * mat3(view.eye_from_world));
}

// Where the ray through `at` passes the line in which two planes meet: exactly, and so whatever the surfaces' depth,
// the jitter, and the small distance of `at` from the line.
Anchor anchor_on(vec4 m, vec4 n, vec2 at) {
    Anchor a;
    a.found = false;
    a.along = 0.0f;
    a.slope = 1.0f;
    vec3 both = cross(vec3(m), vec3(n));
    float square = dot(both, both);
    if (square < 1e-10f)
        return a;
    vec3 foot = (m.w * cross(vec3(n), both) + n.w * cross(both, vec3(m))) / square;  // nearest to the planes' origin
    vec3 along = both / sqrt(square);
    vec3 eye = ray_origin(at);
    vec3 ray = ray_direction(at);
    float slant = dot(ray, along);
    float aside = 1.0f - slant * slant;
    if (aside < 1e-6f)  // seen as a point
        return a;
    vec3 way = eye - foot;
    vec3 nearest = foot + along * ((dot(along, way) - slant * dot(ray, way)) / aside);
    int axis = main_axis(along);
    a.found = true;
    a.along = nearest[axis] + view.local_center[axis];
    a.slope = abs(along[axis]);
    return a;
}

// Of the line in the picture through `at`, on the plane of the surface that ends there.
Anchor anchor_in(vec4 plane, vec2 at, vec2 across) {
    vec3 along = vec3(-across.y, across.x, 0.0f) * mat3(view.eye_from_world);
    vec3 sight = normalize(cross(ray_direction(at), along));
    return anchor_on(plane, vec4(sight, dot(sight, ray_origin(at))), at);
}

// A plane found at a line, and how far from it in pixels.
struct Wall {
    uint plane;
    float beside;
};

// The nearer of `wall` and the planes in which the surface's part ends on the other side, where they meet its own plane.
Wall nearer_wall(Wall wall, Surface s, ivec2 p, ivec2 offset) {
    vec3 ray = pixel_ray(p);
    for (int i = 0; i < layer_count; ++i) {
        Surface t = layer_surface(p, i, ray);
        if (!t.hit)
            break;
        if (t.part != s.part || t.leaving == s.leaving)
            continue;
        float beside = meeting(s, t, offset).beside;
        if (beside < wall.beside) {
            wall.beside = beside;
            wall.plane = t.plane;
        }
    }
    return wall;
}

// The surface of another part that one of `p` touches where it ends, on the way to `q`.
Surface touched(Surface s, ivec2 p, ivec2 q) {
    vec3 ray = pixel_ray(q);
    vec2 gradient = depth_gradient(s.plane);
    for (int i = 0; i < layer_count; ++i) {
        Surface t = layer_surface(q, i, ray);
        if (!t.hit)
            break;
        if (t.part == s.part || t.leaving != s.leaving)
            continue;
        vec2 other = depth_gradient(t.plane);
        if (meet(nearer(s.depth, gradient, t.depth, other, q - p), s, gradient, other, dot(s.normal, t.normal)))
            return t;
    }
    return no_surface();
}

// As edge_of was asked for `e`, which it found.
LineFacts line_facts(int layer, ivec2 p, ivec2 offset, FoundEdge e) {
    LineFacts f = no_facts();
    ivec2 q = p + offset;
    bool ends = e.point.kind == kProfileEdge;
    Surface s = layer_surface(p, layer, pixel_ray(p));
    f.surfaces = e.layer;
    f.solids = ends || layer <= e.other ? solids_before(p, layer) : solids_before(q, e.other);
    Wall wall;
    wall.plane = s.plane;
    wall.beside = 0.75f;
    if (ends) {
        Surface t = touched(s, p, q);
        f.kind = t.hit ? kPartBorder : kSilhouette;
        if (t.hit)
            wall.plane = t.plane;
        else if (e.other >= 0)
            wall.plane = plane_of(surface_ids(p, e.other));
    } else {
        Surface t = layer_surface(q, e.other, pixel_ray(q));
        f.kind = kind_between(s, t, e.bends);
        if (layer == e.other)
            f.solids = min(f.solids, solids_before(q, layer));
        wall.plane = t.plane;
        // A flat border is where the two parts touch, known if that is among the layers.
        if (t.plane == s.plane)
            wall = nearer_wall(nearer_wall(wall, s, p, offset), t, q, -offset);
    }
    bool cut = made_by_section(s);
    if (!ends)
        cut = cut || made_by_section(layer_surface(q, e.other, pixel_ray(q)));
    bool silhouette = f.kind == kSilhouette;
    if (cut)
        f.kind = kSectionEdge;
    f.remoteness = remoteness(s);
    if (clearances)
        f.clearance = clearance_at(s, layer, p);
    vec2 at = vec2(p) + e.point.at * vec2(offset);
    if (wall.plane != s.plane || silhouette) {
        Anchor a = wall.plane == s.plane
                       ? anchor_in(plane_rows[s.plane], at, e.point.across)
                       : anchor_on(plane_rows[min(s.plane, wall.plane)], plane_rows[max(s.plane, wall.plane)], at);
        f.anchored = a.found;
        f.along = a.along;
        f.slope = a.slope;
    }
    return f;
}
