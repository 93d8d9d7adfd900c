#include "compiled_once.h"

COMPILED_ONCE_STAGES(, compiled_once::Surface_mesh_user)
COMPILED_ONCE_STAGES(, compiled_once::Polyhedron_user)
