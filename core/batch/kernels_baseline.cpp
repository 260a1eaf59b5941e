#define UNPROJECTOR_KERNELS kBaselineKernels
#include "core/batch/kernels.inl"
