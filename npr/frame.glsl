// What every pass of a style knows (npr/style_pass.h). Colors are sRGB with straight alpha.
uniform int layer_count;
uniform vec2 jitter;  // of the sample from the pixel's centre, in pixels
uniform vec3 background_color;
uniform vec3 background_stop;
uniform vec3 face_color;
uniform vec3 cut_color;
uniform vec4 highlight_color;
uniform vec4 ghost_color;
uniform bool transparent_background;
