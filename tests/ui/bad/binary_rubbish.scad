ÿþcube(
