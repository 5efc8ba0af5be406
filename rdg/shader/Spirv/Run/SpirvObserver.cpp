// Says in words what an access did.
#include "SpirvObserver.h"

namespace Drydock
{

namespace
{

std::string List(const int64_t* Numbers, int Count, const char* Between)
{
	std::string Text;
	for (int i = 0; i < Count; ++i)
	{
		Text += (i ? Between : "") + std::to_string(Numbers[i]);
	}
	return Text;
}

} // namespace

FSpirvThreadView::~FSpirvThreadView() = default;

double FSpirvThreadView::GetNumber(uint32_t Word, ESpirvType Kind) const
{
	return Kind == ESpirvType::Float || Kind == ESpirvType::Half ? GetReal(Word)
		   : Kind == ESpirvType::Double                          ? __builtin_bit_cast(double, GetWideBits(Word))
		   : Kind == ESpirvType::Long                            ? double(int64_t(GetWideBits(Word)))
		   : Kind == ESpirvType::Ulong                           ? double(GetWideBits(Word))
		   : IsSpirvSigned(Kind)                                 ? double(int32_t(GetBits(Word)))
																 : double(GetBits(Word));
}

ISpirvObserver::~ISpirvObserver() = default;

std::string DescribeFault(const FSpirvFault& Fault)
{
	const std::string Access = Fault.bStore ? "a store to " : "a read of ";
	switch (Fault.Kind)
	{
	case ESpirvFault::Index:
		return "element " + std::to_string(Fault.At[0]) + " of an array that has " + std::to_string(Fault.Bounds[0]) +
			   "; the nearest is taken";
	case ESpirvFault::Texel:
	{
		const bool bNoMip = Fault.Bounds[0] == 0;
		const int Axes = Fault.Bounds[2] > 1 ? 3 : 2;
		return Access + Fault.What + " at (" + List(Fault.At, Axes, ", ") + ")" +
			   (Fault.At[3] || bNoMip ? ", mip " + std::to_string(Fault.At[3]) : std::string()) +
			   (bNoMip ? ", which it does not have" : ", which is " + List(Fault.Bounds, Axes, " x ")) +
			   (Fault.bStore ? "; it is dropped" : "; it gives 0");
	}
	case ESpirvFault::Element:
		return Access + Fault.What + "[" + std::to_string(Fault.At[0]) + "], which has " +
			   std::to_string(Fault.Bounds[0]) + " elements" + (Fault.bStore ? "; it is dropped" : "; it gives 0");
	case ESpirvFault::Level:
		return "a sample of " + Fault.What + " at level " + std::to_string(Fault.At[3]) + ", which has " +
			   std::to_string(Fault.Bounds[0]) + (Fault.Bounds[0] == 1 ? " level" : " levels") + "; the last is taken";
	default:
		return "'" + Fault.What + "' is used before it is written" +
			   (Fault.Bounds[0] > 1 ? " (component " + std::to_string(Fault.At[0]) + ")" : std::string());
	}
}

} // namespace Drydock
