"""The wire contract: modules that the build generates from proto/fovea/v1 come in here."""
