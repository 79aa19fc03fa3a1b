#include "plumbline/lar.hpp"
