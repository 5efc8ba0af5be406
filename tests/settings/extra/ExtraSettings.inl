// The one line.
DRYDOCK_SETTING(float, TestGlimmer, 0.25f, Between(0, 2), "lux", "Test|Extra", Lerp, "A setting for this test alone.")
