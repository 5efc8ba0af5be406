// Walks a type.
#include "LintLayout.h"

#include <algorithm>

namespace Drydock
{

bool LiesAlike(const FSpirvModule& Module, uint32_t TypeId, FStd430& Out)
{
	const FSpirvType& Type = Module.GetType(TypeId);
	bool bAlike = true;
	switch (Type.Kind)
	{
	case ESpirvType::Vector:
	{
		const uint32_t Bytes = GetSpirvBytes(Module.GetType(Type.Element).Kind);
		Out = {Type.Count * Bytes, (Type.Count == 2 ? 2 : 4) * Bytes};
		return true;
	}
	case ESpirvType::Matrix:
		return LiesAlike(Module, Type.Element, Out); // strides of matrices are asked for by who writes them
	case ESpirvType::Array:
	{
		FStd430 Element;
		bAlike = LiesAlike(Module, Type.Element, Element);
		const uint32_t Stride = RoundUp(Element.Size, Element.Alignment);
		Out = {Stride * Type.Count, Element.Alignment};
		return bAlike && (Type.ArrayStride == 0 || Type.ArrayStride == Stride);
	}
	case ESpirvType::Struct:
		Out = {0, 4};
		for (const FSpirvMember& Member : Type.Members)
		{
			FStd430 Inner;
			bAlike = LiesAlike(Module, Member.Type, Inner) && bAlike;
			const uint32_t Offset = RoundUp(Out.Size, Inner.Alignment);
			bAlike = bAlike && Offset == Member.Offset;
			Out = {Offset + Inner.Size, std::max(Out.Alignment, Inner.Alignment)};
		}
		Out.Size = RoundUp(Out.Size, Out.Alignment);
		return bAlike;
	default:
		Out = {GetSpirvBytes(Type.Kind), GetSpirvBytes(Type.Kind)};
		return true;
	}
}

} // namespace Drydock
