// Compiles a thread in both arithmetics.
#include "SpirvThread.inl"
#include "SpirvThreadChecks.inl"
#include "SpirvThreadImages.inl"
#include "SpirvThreadGroups.inl"
#include "SpirvThreadMemory.inl"
#include "SpirvThreadQuads.inl"
#include "SpirvThreadFunctions.inl"
#include "SpirvThreadValues.inl"
#include "SpirvThreadWaves.inl"

namespace Drydock
{

template class TSpirvThread<float>;
template class TSpirvThread<double>;

} // namespace Drydock
