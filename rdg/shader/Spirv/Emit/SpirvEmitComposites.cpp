// Emits vectors and matrices: moves between components, and sums of products.
#include "SpirvEmitter.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

void FSpirvEmitter::EmitDynamicExtract(const FSpirvInstruction& I)
{
	const uint32_t Count = SizeOf(I.Operands[0]);
	const FEmitScalar Index = Scalar(I.Operands[1], 0);
	const ESpirvType Kind = Module.GetScalarKind(I.Type, 0);
	bool bVarying = Index.bVarying;
	for (uint32_t i = 0; i < Count; ++i)
	{
		bVarying = bVarying || Scalar(I.Operands[0], i).bVarying;
	}
	std::string Text = UseAs(Scalar(I.Operands[0], Count - 1), Kind, bVarying);
	for (uint32_t i = Count - 1; i-- > 0;)
	{
		Text = "Select(" + Use(Index) + " == " + Literal(Index.Kind, i).Text + ", " +
			   UseAs(Scalar(I.Operands[0], i), Kind, bVarying) + ", " + Text + ")";
	}
	Define(I.Result, 0, {Text, Kind, bVarying, -1});
}

void FSpirvEmitter::EmitDynamicInsert(const FSpirvInstruction& I)
{
	for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
	{
		const FEmitScalar Index = Scalar(I.Operands[2], 0);
		const FEmitScalar New = Scalar(I.Operands[1], 0);
		const FEmitScalar Old = Scalar(I.Operands[0], i);
		const ESpirvType Kind = Module.GetScalarKind(I.Type, i);
		const bool bVarying = Index.bVarying || New.bVarying || Old.bVarying;
		OperandLevel = EEmitLevel::Tile;
		const std::string Condition = Use(Index) + " == " + Literal(Index.Kind, i).Text;
		Define(I.Result, i,
			{"Select(" + Condition + ", " + UseAs(New, Kind, bVarying) + ", " + UseAs(Old, Kind, bVarying) + ")", Kind,
				bVarying, -1});
	}
}

/** The scalars that a move makes its result of. Empty: the instruction is not a move. */
std::optional<std::vector<FEmitScalar>> FSpirvEmitter::ListMoved(const FSpirvInstruction& I)
{
	std::vector<FEmitScalar> Parts;
	switch (I.Op)
	{
	case OpCopyObject:
		for (uint32_t i = 0; i < SizeOf(I.Operands[0]); ++i)
		{
			Parts.push_back(Scalar(I.Operands[0], i));
		}
		break;
	case OpVectorShuffle:
	{
		const uint32_t First = SizeOf(I.Operands[0]);
		for (size_t k = 2; k < I.Operands.size(); ++k)
		{
			const uint32_t From = I.Operands[k];
			Parts.push_back(From == ~0u    ? Literal(Module.GetScalarKind(I.Type, 0), 0)
							: From < First ? Scalar(I.Operands[0], From)
										   : Scalar(I.Operands[1], From - First));
		}
		break;
	}
	case OpCompositeConstruct:
		for (const uint32_t Operand : I.Operands)
		{
			for (uint32_t i = 0; i < SizeOf(Operand); ++i)
			{
				Parts.push_back(Scalar(Operand, i));
			}
		}
		break;
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const size_t Composite = I.Op == OpCompositeInsert ? 1 : 0;
		const auto [Offset, Type] = Module.FindPart(Module.GetValueTypeId(I.Operands[Composite]),
			I.Operands.data() + Composite + 1, I.Operands.data() + I.Operands.size());
		const uint32_t Size = Module.GetType(Type).NumScalars;
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			const bool bPart = i >= Offset && i < Offset + Size;
			Parts.push_back(I.Op == OpCompositeExtract ? Scalar(I.Operands[0], Offset + i)
							: bPart                    ? Scalar(I.Operands[0], i - Offset)
													   : Scalar(I.Operands[1], i));
		}
		break;
	}
	case OpTranspose:
	{
		const uint32_t Columns = Module.GetType(I.Type).Count;
		const uint32_t Rows = SizeOf(I.Result) / Columns;
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			Parts.push_back(Scalar(I.Operands[0], (i % Rows) * Columns + i / Rows));
		}
		break;
	}
	default:
		return {};
	}
	return Parts;
}

bool FSpirvEmitter::EmitComposite(const FSpirvInstruction& I)
{
	if (I.Op == OpVectorExtractDynamic)
	{
		EmitDynamicExtract(I);
		return true;
	}
	if (I.Op == OpVectorInsertDynamic)
	{
		EmitDynamicInsert(I);
		return true;
	}
	const std::optional<std::vector<FEmitScalar>> Parts = ListMoved(I);
	for (uint32_t i = 0; Parts && i < Parts->size(); ++i)
	{
		// Moves are free: the result's scalars are the sources' own, unless lanes must keep what uniform code computed.
		const FEmitScalar& Part = (*Parts)[i];
		if (Uniformity.IsVarying(I.Result, i) && !Part.bVarying)
		{
			OperandLevel = EEmitLevel::Tile;
			Define(I.Result, i, Part);
			continue;
		}
		std::vector<FEmitScalar>& List = Values[I.Result];
		List.resize(std::max<size_t>(List.size(), i + 1));
		List[i] = Part;
	}
	return Parts.has_value();
}

/** Sums run in ascending order, as Dot and Mul of the lanes do. */
void FSpirvEmitter::EmitSum(const FSpirvInstruction& I, uint32_t Index, const std::vector<FTerm>& Terms)
{
	std::string Text;
	bool bVarying = false;
	OperandLevel = EEmitLevel::Tile;
	for (const FTerm& Term : Terms)
	{
		Text += std::string(Text.empty() ? "" : " + ") + Use(Term.A) + " * " + Use(Term.B);
		bVarying = bVarying || Term.A.bVarying || Term.B.bVarying;
	}
	const ESpirvType Kind = Module.GetScalarKind(I.Type, 0);
	Define(I.Result, Index, {WithDenormals(Kind, Text), Kind, bVarying, -1});
}

bool FSpirvEmitter::EmitMatrix(const FSpirvInstruction& I)
{
	const uint32_t Size = SizeOf(I.Result);
	switch (I.Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Size; ++i)
		{
			EmitSum(I, i, {{Scalar(I.Operands[0], i), Scalar(I.Operands[1], 0)}});
		}
		return true;
	case OpDot:
	case OpVectorTimesMatrix:
	{
		const uint32_t Rows = SizeOf(I.Operands[0]);
		for (uint32_t Column = 0; Column < Size; ++Column)
		{
			std::vector<FTerm> Terms;
			for (uint32_t Row = 0; Row < Rows; ++Row)
			{
				Terms.push_back({Scalar(I.Operands[0], Row), Scalar(I.Operands[1], Column * Rows + Row)});
			}
			EmitSum(I, Column, Terms);
		}
		return true;
	}
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	{
		const uint32_t Inner = Module.GetValueType(I.Operands[0]).Count;
		const uint32_t Rows = SizeOf(I.Operands[0]) / Inner;
		for (uint32_t i = 0; i < Size; ++i)
		{
			std::vector<FTerm> Terms;
			for (uint32_t k = 0; k < Inner; ++k)
			{
				Terms.push_back(
					{Scalar(I.Operands[0], k * Rows + i % Rows), Scalar(I.Operands[1], i / Rows * Inner + k)});
			}
			EmitSum(I, i, Terms);
		}
		return true;
	}
	case OpOuterProduct:
	{
		const uint32_t Rows = SizeOf(I.Operands[0]);
		for (uint32_t i = 0; i < Size; ++i)
		{
			EmitSum(I, i, {{Scalar(I.Operands[0], i % Rows), Scalar(I.Operands[1], i / Rows)}});
		}
		return true;
	}
	case OpAny:
	case OpAll:
	{
		std::string Text;
		bool bVarying = false;
		for (uint32_t i = 0; i < SizeOf(I.Operands[0]); ++i)
		{
			const FEmitScalar Part = Scalar(I.Operands[0], i);
			Text += std::string(Text.empty() ? "" : I.Op == OpAny ? " || " : " && ") + Use(Part);
			bVarying = bVarying || Part.bVarying;
		}
		Define(I.Result, 0, {Text, ESpirvType::Bool, bVarying, -1});
		return true;
	}
	default:
		return false;
	}
}

} // namespace Drydock
