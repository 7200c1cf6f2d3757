// Straight visible edges, drawn on beyond their ends, as a hand does (npr/edges/overshoot.h). Valid in shaders and, within a
// struct with the same names, in C++. Both have what is read and written:
//   visible_edge(lower, axis)         the edge of the first layer on a link; its kind is 0 where there is none
//   draw_beyond(lower, axis, point)   a continuation; where there are several on a link, the strongest counts

bool in_line(EdgePoint e, ivec2 lower, int axis, vec2 at, vec2 across) {
    vec2 apart = vec2(lower) + e.at * vec2(1 - axis, axis) - at;
    return abs(dot(e.across, across)) > 0.985f && abs(dot(apart, across)) < 0.75f && dot(apart, apart) < 1.6f;
}

// Is there a visible edge at this place, in this direction?
bool line_at(vec2 at, vec2 across) {
    ivec4 window = links_near(at, 1.0f);
    for (int y = window.y; y <= window.w; ++y)
        for (int x = window.x; x <= window.z; ++x)
            for (int axis = 0; axis < 2; ++axis) {
                EdgePoint e = visible_edge(ivec2(x, y), axis);
                if (e.kind != 0u && in_line(e, ivec2(x, y), axis, at, across))
                    return true;
            }
    return false;
}

// How far the edge goes back in a straight line, about; 0 where it does not end here.
float straight_length(EdgePoint e, vec2 from, vec2 direction) {
    if (line_at(from + 2.0f * direction, e.across) || line_at(from + 3.5f * direction, e.across))
        return 0.0f;
    float behind = 4.0f;
    while (behind <= 2.5f * overshoot && line_at(from - behind * direction, e.across))
        behind += 4.0f;
    return behind - 4.0f;
}

void draw_on(EdgePoint e, vec2 from, vec2 direction, float reach) {
    bool steep = abs(direction.y) > abs(direction.x);
    vec2 stride = direction / (steep ? abs(direction.y) : abs(direction.x));
    // The points in which the line crosses the rows or columns of samples.
    float first = steep ? from.y : from.x;
    bool onward = (steep ? direction.y : direction.x) > 0.0f;
    vec2 at = from + (onward ? ceil(first) - first : first - floor(first)) * stride;
    int axis = steep ? 0 : 1;
    ivec2 last = picture_size() - 2;
    for (float way = 0.0f; way < reach; way += length(stride)) {
        ivec2 lower = ivec2(steep ? floor(at.x) : round(at.x), steep ? round(at.y) : floor(at.y));
        if (any(lessThan(lower, ivec2(0))) || any(greaterThan(lower, last)))
            return;
        e.at = steep ? at.x - float(lower.x) : at.y - float(lower.y);
        e.thickness = 1.0f - 0.85f * way / reach;
        draw_beyond(lower, axis, e);
        at += stride;
    }
}

// The continuations of the visible edge on a link, if there is one.
void draw_on_link(ivec2 lower, int axis) {
    EdgePoint e = visible_edge(lower, axis);
    if (e.kind == 0u)
        return;
    vec2 from = vec2(lower) + e.at * vec2(1 - axis, axis);
    for (float turn = -1.0f; turn < 2.0f; turn += 2.0f) {
        vec2 direction = turn * vec2(-e.across.y, e.across.x);
        // Short edges are not drawn on as far as long ones, and bows not at all.
        float straight = straight_length(e, from, direction);
        if (straight > 10.0f)
            draw_on(e, from, direction, min(overshoot, 0.35f * straight));
    }
}
