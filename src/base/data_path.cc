#include "base/data_path.h"
