#include "compiled_once.h"

COMPILED_ONCE_STAGES(, compiled_once::Surface_mesh_user)
COMPILED_ONCE_STAGES(, compiled_once::Polyhedron_user)

COMPILED_ONCE_MODEL(, Input_surface)
COMPILED_ONCE_MODEL(, Input_model)

COMPILED_ONCE_REPAIRS()
COMPILED_ONCE_SMOOTHING()
COMPILED_ONCE_FITS(, 2)
COMPILED_ONCE_FITS(, 3)
COMPILED_ONCE_FITS(, 4)

COMPILED_ONCE_FILES(, CGAL::Surface_mesh<compiled_once::Kernel::Point_3>)
