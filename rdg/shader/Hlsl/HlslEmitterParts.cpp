// Conversions between numeric types, and values out of the scalars of others.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

uint32_t FEmitter::Construct(uint32_t Type, const FWords& Ids)
{
	FWords Words = {Type};
	Words.insert(Words.end(), Ids.begin(), Ids.end());
	const bool bConstant = std::ranges::all_of(Ids, [this](uint32_t Id) { return Module.IsConstant(Id); });
	return bConstant ? Module.Intern(OpConstantComposite, Words) : Op(OpCompositeConstruct, Type, Ids);
}

uint32_t FEmitter::ExtractAt(uint32_t Id, uint32_t Type, const FWords& Path)
{
	if (Path.empty())
	{
		return Id;
	}
	FWords Words = {Id};
	Words.insert(Words.end(), Path.begin(), Path.end());
	return Op(OpCompositeExtract, Type, Words);
}

uint32_t FEmitter::Extract(uint32_t Id, const FType* Type, uint32_t Scalar)
{
	FWords Path;
	while (!Type->IsNumeric())
	{
		if (Type->IsArray())
		{
			const uint32_t Each = CountScalars(Type->Element);
			Path.push_back(Scalar / std::max(Each, 1u));
			Scalar %= std::max(Each, 1u);
			Type = Type->Element;
			continue;
		}
		uint32_t Index = 0;
		const FType* Next = nullptr;
		for (const FMember& Member : Type->Struct->Members)
		{
			const uint32_t Each = CountScalars(Member.Type);
			if (Scalar < Each)
			{
				Next = Member.Type;
				break;
			}
			Scalar -= Each;
			Index += Each > 0 ? 1 : 0;
		}
		Path.push_back(Index);
		Type = Next;
	}
	if (Type->IsMatrix())
	{
		Path.push_back(Scalar / Type->Columns);
	}
	if (Type->Columns > 1)
	{
		Path.push_back(Scalar % Type->Columns);
	}
	return ExtractAt(Id, ScalarType(Type->Scalar), Path);
}

uint32_t FEmitter::Shuffle(uint32_t Id, EScalar Scalar, uint32_t Count, const std::vector<uint8_t>& Parts)
{
	const uint32_t Size = uint32_t(Parts.size());
	if (Count == 1)
	{
		return Splat(Id, ScalarType(Scalar), Size);
	}
	if (Size == 1)
	{
		return ExtractAt(Id, ScalarType(Scalar), {Parts[0]});
	}
	FWords Words = {Id, Id};
	bool bSame = Size == Count;
	for (uint32_t i = 0; i < Size; ++i)
	{
		Words.push_back(Parts[i]);
		bSame = bSame && Parts[i] == i;
	}
	return bSame ? Id : Op(OpVectorShuffle, VectorOf(Scalar, Size), Words);
}

uint32_t FEmitter::Build(const FType* To, const std::vector<FPart>& Parts)
{
	size_t Part = 0;
	uint32_t Offset = 0;
	return CountScalars(To) == 0 ? 0 : BuildPart(To, Parts, Part, Offset);
}

/** Takes scalars from Parts[Part] on, Offset of which are taken already. */
uint32_t FEmitter::BuildPart(const FType* To, const std::vector<FPart>& Parts, size_t& Part, uint32_t& Offset)
{
	while (Part < Parts.size() && CountScalars(Parts[Part].Type) == 0)
	{
		++Part;
	}
	if (Part < Parts.size() && Offset == 0 && TypeOf(Parts[Part].Type) == TypeOf(To))
	{
		return Parts[Part++].Id;
	}
	FWords Ids;
	if (To->IsArray() || To->IsMatrix())
	{
		const FType* const Element = To->IsArray() ? To->Element : RowOf(To);
		for (uint32_t i = 0; i < (To->IsArray() ? To->Count : To->Rows); ++i)
		{
			Ids.push_back(BuildPart(Element, Parts, Part, Offset));
		}
		return Construct(TypeOf(To), Ids);
	}
	if (To->IsStruct())
	{
		for (const FMember& Member : To->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				Ids.push_back(BuildPart(Member.Type, Parts, Part, Offset));
			}
		}
		return Construct(TypeOf(To), Ids);
	}
	for (uint32_t Left = To->Columns; Left > 0;)
	{
		if (Part >= Parts.size())
		{
			Ids.insert(Ids.end(), Left, Module.Null(ScalarType(To->Scalar)));
			break;
		}
		const FPart& From = Parts[Part];
		const uint32_t Size = CountScalars(From.Type);
		const bool bWhole = Offset == 0 && From.Type->IsNumeric() && !From.Type->IsMatrix() && Size <= Left;
		const uint32_t Taken = bWhole ? Size : 1;
		if (Taken > 0 && Offset < Size)
		{
			const EScalar Scalar = GetScalarAt(From.Type, Offset);
			const uint32_t Id = bWhole ? From.Id : Extract(From.Id, From.Type, Offset);
			Ids.push_back(ConvertScalars(Id, Scalar, To->Scalar, Taken));
		}
		Offset += Taken;
		Left -= Taken;
		if (Offset >= Size)
		{
			++Part;
			Offset = 0;
		}
	}
	return Ids.size() == 1 ? Ids[0] : Construct(TypeOf(To), Ids);
}

uint32_t FEmitter::ByRows(const FType* Result, const std::vector<FPart>& Operands, const FRowWork& Work)
{
	FWords Ids;
	if (!Result->IsMatrix())
	{
		for (const FPart& Operand : Operands)
		{
			Ids.push_back(Operand.Id);
		}
		return Work(Result, Ids);
	}
	FWords Rows;
	for (uint32_t r = 0; r < Result->Rows; ++r)
	{
		Ids.clear();
		for (const FPart& Operand : Operands)
		{
			const bool bMatrix = Operand.Type->IsMatrix();
			Ids.push_back(bMatrix ? ExtractAt(Operand.Id, TypeOf(RowOf(Operand.Type)), {r}) : Operand.Id);
		}
		Rows.push_back(Work(RowOf(Result), Ids));
	}
	return Construct(TypeOf(Result), Rows);
}

/** Scalar by scalar; operands of one scalar are given to each. */
uint32_t FEmitter::ByScalars(const FType* Result, const std::vector<FPart>& Operands, const FRowWork& Work)
{
	FWords Scalars;
	const uint32_t Size = CountScalars(Result);
	for (uint32_t i = 0; i < Size; ++i)
	{
		FWords Ids;
		for (const FPart& Operand : Operands)
		{
			Ids.push_back(CountScalars(Operand.Type) == 1 ? Operand.Id : Extract(Operand.Id, Operand.Type, i));
		}
		Scalars.push_back(Work(Types.Scalar(GetScalarAt(Result, i)), Ids));
	}
	std::vector<FPart> Parts;
	for (uint32_t i = 0; i < Size; ++i)
	{
		Parts.push_back({Scalars[i], Types.Scalar(GetScalarAt(Result, i))});
	}
	return Build(Result, Parts);
}

/** Count scalars, as a vector where there are several. */
uint32_t FEmitter::ConvertScalars(uint32_t Id, EScalar From, EScalar To, uint32_t Count)
{
	const ENumber Source = KindOf(From);
	const ENumber Wanted = KindOf(To);
	const uint32_t FromBits = Bits(From);
	const uint32_t ToBits = Bits(To);
	const uint32_t Type = VectorOf(To, Count);
	if (Source == Wanted && (FromBits == ToBits || Source == ENumber::Bool))
	{
		return Id;
	}
	const auto Number = [&](double Value)
	{
		const uint32_t Scalar = IsReal(To) ? RealConstant(To, Value) : ScalarConstant(To, uint64_t(Value));
		return Splat(Scalar, ScalarType(To), Count);
	};
	if (Source == ENumber::Bool)
	{
		return Op(OpSelect, Type, {Id, Number(1), Number(0)});
	}
	if (Wanted == ENumber::Bool)
	{
		const uint32_t Zero =
			Splat(IsReal(From) ? RealConstant(From, 0) : ScalarConstant(From, 0), ScalarType(From), Count);
		return Op(Source == ENumber::Real ? OpFUnordNotEqual : OpINotEqual, Type, {Id, Zero});
	}
	if (Source == ENumber::Real)
	{
		if (Wanted == ENumber::Real)
		{
			return Op(OpFConvert, Type, {Id});
		}
		if (ToBits < 32) // through int
		{
			const uint32_t Int = Op(OpConvertFToS, VectorOf(EScalar::Int, Count), {Id});
			return ConvertScalars(Int, EScalar::Int, To, Count);
		}
		return Op(Wanted == ENumber::Signed ? OpConvertFToS : OpConvertFToU, Type, {Id});
	}
	if (Wanted == ENumber::Real)
	{
		return Op(Source == ENumber::Signed ? OpConvertSToF : OpConvertUToF, Type, {Id});
	}
	if (FromBits != ToBits) // a sign goes on as the source has it
	{
		const bool bSigned = Source == ENumber::Signed;
		const EScalar Same = ToBits == 64   ? (bSigned ? EScalar::Long : EScalar::Ulong)
							 : ToBits == 16 ? (bSigned ? EScalar::Short : EScalar::Ushort)
											: (bSigned ? EScalar::Int : EScalar::Uint);
		const uint32_t Wide = Op(bSigned ? OpSConvert : OpUConvert, VectorOf(Same, Count), {Id});
		return KindOf(Same) == Wanted ? Wide : Op(OpBitcast, Type, {Wide});
	}
	return Op(OpBitcast, Type, {Id});
}

uint32_t FEmitter::Convert(uint32_t Id, const FType* From, const FType* To)
{
	if (IsSame(From, To))
	{
		return Id;
	}
	if (!From->IsNumeric() || !To->IsNumeric())
	{
		return From->IsObject() ? Id : Build(To, {{Id, From}});
	}
	const bool bSameShape =
		From->Rows == To->Rows && From->Columns == To->Columns && From->IsMatrix() == To->IsMatrix();
	if (bSameShape)
	{
		return ByRows(To, {{Id, From}},
			[&](const FType* Row, const FWords& Ids)
			{ return ConvertScalars(Ids[0], From->Scalar, To->Scalar, Row->Columns); });
	}
	const uint32_t Size = From->NumComponents();
	if (Size == 1)
	{
		const uint32_t Scalar = ConvertScalars(
			From->IsMatrix() ? ExtractAt(Id, ScalarType(From->Scalar), {0}) : Id, From->Scalar, To->Scalar, 1);
		const uint32_t Row = Splat(Scalar, ScalarType(To->Scalar), To->Columns);
		return To->IsMatrix() ? Construct(TypeOf(To), FWords(To->Rows, Row)) : Row;
	}
	if (!From->IsMatrix() && !To->IsMatrix()) // a vector is cut down
	{
		std::vector<uint8_t> Parts;
		for (uint32_t i = 0; i < To->Columns; ++i)
		{
			Parts.push_back(uint8_t(std::min(i, Size - 1)));
		}
		return ConvertScalars(Shuffle(Id, From->Scalar, Size, Parts), From->Scalar, To->Scalar, To->Columns);
	}
	std::vector<FPart> Scalars;
	const bool bMatrices = From->IsMatrix() && To->IsMatrix() && From->Columns >= To->Columns && From->Rows >= To->Rows;
	for (uint32_t i = 0; i < To->NumComponents(); ++i)
	{
		const uint32_t At = bMatrices ? i / To->Columns * From->Columns + i % To->Columns : i;
		Scalars.push_back({Extract(Id, From, std::min(At, Size - 1)), Types.Scalar(From->Scalar)});
	}
	return Build(To, Scalars);
}

} // namespace Drydock::Hlsl
