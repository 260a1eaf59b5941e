#define UNPROJECTOR_KERNELS kAvx512Kernels
#include "core/batch/kernels.inl"
