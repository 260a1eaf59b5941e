#define UNPROJECTOR_KERNELS kAvx2Kernels
#include "core/batch/kernels.inl"
