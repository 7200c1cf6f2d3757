// The way on which a surface ends, from link to link, and the straight line that it follows there. It tells where an
// outline is whose other side is no layer: a face seen edge-on. Valid in shaders and, within a struct with the same
// names, in C++.

// A link on which a surface ends, on the way from a pixel to its neighbor at `offset`.
struct EndLink {
    bool found;
    ivec2 pixel;  // that has the surface
    int layer;
    ivec2 offset;
};

vec2 middle_of(EndLink link) {
    return vec2(link.pixel) + 0.5f * vec2(link.offset);
}

// The next one, where the surface's border goes on in the direction `on`, which is across the link.
EndLink next_end(EndLink link, ivec2 on) {
    EndLink next = link;
    next.found = false;
    ivec2 beside = link.pixel + on;
    ivec2 ahead = beside + link.offset;
    if (!in_picture(beside) || !in_picture(ahead))
        return next;
    next.found = true;
    Continuation c = continuation_at(link.pixel, link.layer, on);
    next.offset = on;
    if (!c.found)
        return next;
    next.pixel = beside;
    next.layer = c.layer;
    next.offset = link.offset;
    c = continuation_at(beside, next.layer, link.offset);
    if (!c.found)
        return next;
    next.pixel = ahead;
    next.layer = c.layer;
    next.offset = -on;
    return next;
}

const int kContour = 7;  // links to either side, at most
const int kContourNear = 4;

// Links on the border of a surface; the one that was asked for is number kContour.
struct Contour {
    vec2 at[15];  // their middles
    int first;    // of those that are known
    int last;
    EndLink begin;  // the first of them
    EndLink end;    // the last
    uint facet;
    bool one_facet;  // Is it one plane that ends there?
};

Contour contour_at(EndLink link) {
    Contour c;
    c.at[kContour] = middle_of(link);
    c.first = kContour;
    c.last = kContour;
    c.begin = link;
    c.end = link;
    c.facet = surface_ids(link.pixel, link.layer).y;
    c.one_facet = true;
    return c;
}

// So many to either side, if the border goes on so far.
Contour longer_contour(Contour c, int links) {
    for (int way = -1; way <= 1; way += 2) {
        EndLink end = c.end;
        int known = c.last - kContour;
        if (way < 0) {
            end = c.begin;
            known = kContour - c.first;
        }
        while (end.found && known < links) {
            // To the left of the way out, or to the right.
            end = next_end(end, way * ivec2(-end.offset.y, end.offset.x));
            if (end.found) {
                ++known;
                c.at[kContour + way * known] = middle_of(end);
                c.one_facet = c.one_facet && surface_ids(end.pixel, end.layer).y == c.facet;
            }
        }
        if (way < 0) {
            c.begin = end;
            c.first = kContour - known;
        } else {
            c.end = end;
            c.last = kContour + known;
        }
    }
    return c;
}

// Do the links lie in a band along the straight line through the first and the last of them that is as wide as a pixel?
bool in_band(Contour c, int first, int last) {
    vec2 chord = c.at[last] - c.at[first];
    vec2 across = vec2(-chord.y, chord.x) / max(length(chord), 1e-6f);
    vec2 range = vec2(0.0f);
    for (int i = first + 1; i < last; ++i) {
        float beside = dot(c.at[i] - c.at[first], across);
        range = vec2(min(range.x, beside), max(range.y, beside));
    }
    return range.y - range.x <= 1.05f;
}

// A straight line that crosses a link.
struct Straight {
    float at;
    vec2 across;
};

// The one that follows the border, and crosses as many of its links as one can: their middles are in a band as wide as
// a pixel at most.
Straight straight_border(Contour c, EndLink link) {
    int first = kContour;
    int last = kContour;
    bool back = true;
    bool on = true;
    while (back || on) {
        on = on && last < c.last && in_band(c, first, last + 1);
        last += on ? 1 : 0;
        back = back && first > c.first && in_band(c, first - 1, last);
        first -= back ? 1 : 0;
    }
    Straight s;
    s.at = 0.5f;
    s.across = vec2(link.offset);
    if (last == first)
        return s;
    // The line with the least squares of distances.
    float count = float(last - first + 1);
    vec2 center = vec2(0.0f);
    for (int i = first; i <= last; ++i)
        center += c.at[i] / count;
    vec3 moments = vec3(0.0f);
    for (int i = first; i <= last; ++i) {
        vec2 d = c.at[i] - center;
        moments += vec3(d.x * d.x, d.x * d.y, d.y * d.y);
    }
    float angle = 0.5f * atan(2.0f * moments.y, moments.x - moments.z);
    s.across = vec2(-sin(angle), cos(angle));
    float closing = dot(s.across, vec2(link.offset));
    if (abs(closing) > 0.1f)
        s.at = clamp(dot(center - vec2(link.pixel), s.across) / closing, 0.0f, 1.0f);
    return s;
}

// Does a straight line cross the other links, too, but for a bend?
bool follows(Contour c, EndLink link, Straight s) {
    if (!c.one_facet)
        return false;
    vec2 point = vec2(link.pixel) + s.at * vec2(link.offset);
    float most = 0.5f * max(abs(s.across.x), abs(s.across.y)) + 0.1f;
    for (int i = c.first; i <= c.last; ++i) {
        vec2 way = c.at[i] - point;
        if (abs(dot(way, s.across)) > most + 0.025f * dot(way, way))
            return false;
    }
    return true;
}
