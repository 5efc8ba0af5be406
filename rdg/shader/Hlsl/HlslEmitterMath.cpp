// Functions of HLSL that take numbers apart: their bits, their bytes, their exponents.
#include "HlslEmitterImpl.h"

namespace Drydock::Hlsl
{

using namespace Spirv;

/** modf, frexp, sincos and asuint of a double: what they give back goes to places. */
uint32_t FEmitter::Parting(const FValue& Node, const FArguments& In)
{
	const FType* const Of = In[0].Type;
	const uint32_t X = In[0].Id;
	const auto Give = [&](size_t i, uint32_t Id, const FType* Type)
	{
		const FValue& Argument = *Node.Operands[i];
		Store(Place(Argument), Convert(Id, Type, Argument.Type));
	};
	const auto Each = [&](uint32_t Number)
	{
		return ByRows(Of, In, [&](const FType* Part, const FWords& Ids) { return Ext(Number, TypeOf(Part), Ids); });
	};
	if (Node.Name == "sincos")
	{
		Give(1, Each(ExtSin), Of);
		Give(2, Each(ExtCos), Of);
		return 0;
	}
	if (Node.Name == "modf")
	{
		const uint32_t Whole = Each(ExtTrunc);
		Give(1, Whole, Of);
		return Arithmetic("-", Of, X, Whole, Of);
	}
	if (Node.Name == "asuint")
	{
		for (uint32_t k = 0; k < 2; ++k)
		{
			const uint32_t Half = ByScalars(Types.WithScalar(Of, EScalar::Uint), In,
				[&](const FType*, const FWords& Ids)
				{
					const uint32_t Pair = Op(OpBitcast, VectorOf(EScalar::Uint, 2), Ids);
					return ExtractAt(Pair, Module.Uint(), {k});
				});
			Give(1 + k, Half, Types.WithScalar(Of, EScalar::Uint));
		}
		return 0;
	}
	// frexp: the exponent's bits, and those of a number from 0.5 to 1. 0 is 0 times 2^0.
	constexpr uint32_t Exponent = 0x7F800000;
	constexpr uint32_t Rest = 0x807FFFFF;
	constexpr uint32_t OfHalf = 0x3F000000;
	const FType* const Floats = Types.WithScalar(Of, EScalar::Float);
	const FType* const Ints = Types.WithScalar(Of, EScalar::Int);
	const uint32_t Wide = Convert(X, Of, Floats);
	uint32_t Exponents = 0;
	FWords Rows[2];
	const uint32_t Fraction = ByRows(Floats, {{Wide, Floats}},
		[&](const FType* Part, const FWords& Ids)
		{
			const uint32_t Type = VectorOf(EScalar::Int, Part->Columns);
			const auto Number = [&](uint32_t Bits)
			{
				return Splat(Module.Int(int32_t(Bits)), Module.Int(), Part->Columns);
			};
			const uint32_t Bits = Op(OpBitcast, Type, Ids);
			const uint32_t Zero =
				Op(OpFOrdEqual, VectorOf(EScalar::Bool, Part->Columns), {Ids[0], Module.Null(TypeOf(Part))});
			const uint32_t Masked = Op(OpBitwiseAnd, Type, {Bits, Number(Exponent)});
			const uint32_t Shifted =
				Op(OpShiftRightArithmetic, Type, {Op(OpISub, Type, {Masked, Number(OfHalf)}), Number(23)});
			Rows[0].push_back(Op(OpSelect, Type, {Zero, Number(0), Shifted}));
			const uint32_t Between =
				Op(OpBitwiseOr, Type, {Op(OpBitwiseAnd, Type, {Bits, Number(Rest)}), Number(OfHalf)});
			return Op(OpSelect, TypeOf(Part), {Zero, Ids[0], Op(OpBitcast, TypeOf(Part), {Between})});
		});
	Exponents = Rows[0].size() == 1 ? Rows[0][0] : Construct(TypeOf(Ints), Rows[0]);
	Give(1, Exponents, Ints);
	return Convert(Fraction, Floats, Node.Type);
}

/** firstbithigh, firstbitlow, countbits or reversebits of integers of 32 bits. */
uint32_t FEmitter::OfWord(std::string_view Name, EScalar Scalar, uint32_t Count, uint32_t Id)
{
	const uint32_t Type = VectorOf(Scalar, Count);
	return Name == "countbits"     ? Op(OpBitCount, Type, {Id})
		   : Name == "reversebits" ? Op(OpBitReverse, Type, {Id})
		   : Name == "firstbitlow" ? Ext(ExtFindILsb, Type, {Id})
								   : Ext(Scalar == EScalar::Int ? ExtFindSMsb : ExtFindUMsb, Type, {Id});
}

/** SPIR-V has them for 32 bits: 16 are widened, of 64 each half is looked at. No bit at all is -1. */
uint32_t FEmitter::OfBits(const FValue& Node, const FArguments& In)
{
	const std::string_view Name = Node.Name;
	const EScalar Scalar = In[0].Type->Scalar;
	const uint32_t Width = Bits(Scalar);
	const bool bSigned = KindOf(Scalar) == ENumber::Signed;
	const bool bHigh = Name == "firstbithigh";
	const auto OfRow = [&](const FType* Part, const FWords& Ids)
	{
		const uint32_t Count = Part->Columns;
		const uint32_t Word = VectorOf(EScalar::Uint, Count);
		const auto To = [&](uint32_t Id, EScalar From)
		{
			return ConvertScalars(Id, From, Part->Scalar, Count);
		};
		const auto Number = [&](uint32_t Value)
		{
			return Splat(Module.Uint(Value), Module.Uint(), Count);
		};
		if (Width == 32)
		{
			const EScalar Own = bSigned ? EScalar::Int : EScalar::Uint;
			return To(OfWord(Name, Own, Count, Ids[0]), Own);
		}
		if (Width == 16)
		{
			const bool bKeepSign = bHigh && bSigned;
			const EScalar Wide = bKeepSign ? EScalar::Int : EScalar::Uint;
			const EScalar Narrow = bKeepSign ? EScalar::Short : EScalar::Ushort;
			const uint32_t Same = ConvertScalars(Ids[0], Scalar, Narrow, Count);
			const uint32_t Found = OfWord(Name, Wide, Count, ConvertScalars(Same, Narrow, Wide, Count));
			return To(Name == "reversebits" ? Op(OpShiftRightLogical, Word, {Found, Number(16)}) : Found, Wide);
		}
		const uint32_t Long = VectorOf(EScalar::Ulong, Count);
		const uint32_t HalfWidth = Splat(ScalarConstant(EScalar::Ulong, 32), ScalarType(EScalar::Ulong), Count);
		uint32_t Id = Ids[0];
		if (bHigh && bSigned) // the highest bit that is not the sign
		{
			const uint32_t Last = Splat(ScalarConstant(Scalar, 63), ScalarType(Scalar), Count);
			const uint32_t Own = VectorOf(Scalar, Count);
			Id = Op(OpBitwiseXor, Own, {Id, Op(OpShiftRightArithmetic, Own, {Id, Last})});
		}
		Id = ConvertScalars(Id, Scalar, EScalar::Ulong, Count);
		const uint32_t LowHalf = ConvertScalars(Id, EScalar::Ulong, EScalar::Uint, Count);
		const uint32_t HighHalf =
			ConvertScalars(Op(OpShiftRightLogical, Long, {Id, HalfWidth}), EScalar::Ulong, EScalar::Uint, Count);
		const uint32_t Low = OfWord(Name, EScalar::Uint, Count, LowHalf);
		const uint32_t High = OfWord(Name, EScalar::Uint, Count, HighHalf);
		if (Name == "countbits")
		{
			return To(Op(OpIAdd, Word, {Low, High}), EScalar::Uint);
		}
		if (Name == "reversebits")
		{
			const uint32_t Upper = ConvertScalars(Low, EScalar::Uint, EScalar::Ulong, Count);
			const uint32_t Lower = ConvertScalars(High, EScalar::Uint, EScalar::Ulong, Count);
			const uint32_t Shifted = Op(OpShiftLeftLogical, Long, {Upper, HalfWidth});
			return To(Op(OpBitwiseOr, Long, {Shifted, Lower}), EScalar::Ulong);
		}
		const uint32_t Above = Op(OpBitwiseOr, Word, {High, Number(32)}); // -1 stays -1
		const uint32_t None = Op(OpIEqual, VectorOf(EScalar::Bool, Count), {bHigh ? HighHalf : LowHalf, Number(0)});
		return To(
			bHigh ? Op(OpSelect, Word, {None, Low, Above}) : Op(OpSelect, Word, {None, Above, Low}), EScalar::Uint);
	};
	return ByRows(Node.Type, In, OfRow);
}

uint32_t FEmitter::Lighting(const FValue& Node, const FArguments& In)
{
	const EScalar Scalar = Node.Type->Scalar;
	const uint32_t Type = ScalarType(Scalar);
	const uint32_t One = RealConstant(Scalar, 1);
	const uint32_t Zero = RealConstant(Scalar, 0);
	const auto Of = [&](size_t i, uint32_t c)
	{
		return Extract(In[i].Id, In[i].Type, c);
	};
	if (Node.Name == "dst")
	{
		const uint32_t Y = Op(OpFMul, Type, {Of(0, 1), Of(1, 1)});
		return Construct(TypeOf(Node.Type), {One, Y, Of(0, 2), Of(1, 3)});
	}
	const uint32_t Diffuse = Ext(ExtNMax, Type, {In[0].Id, Zero});
	const uint32_t Least = Ext(ExtNMin, Type, {In[0].Id, In[1].Id});
	const uint32_t Dark = Op(OpFOrdLessThan, Module.Bool(), {Least, Zero});
	const uint32_t Power = Ext(ExtPow, Type, {In[1].Id, In[2].Id});
	return Construct(TypeOf(Node.Type), {One, Diffuse, Op(OpSelect, Type, {Dark, Zero, Power}), One});
}

/** Half floats in words, and bytes in words. */
uint32_t FEmitter::Packing(const FValue& Node, const FArguments& In)
{
	const std::string_view Name = Node.Name;
	const uint32_t Uint = Module.Uint();
	if (Name == "f16tof32" || Name == "f32tof16")
	{
		const uint32_t Pair = VectorOf(EScalar::Float, 2);
		return ByScalars(Node.Type, In,
			[&](const FType* Part, const FWords& Ids)
			{
				if (Name == "f32tof16")
				{
					const uint32_t Both = Construct(Pair, {Ids[0], RealConstant(EScalar::Float, 0)});
					return Ext(ExtPackHalf2x16, TypeOf(Part), {Both});
				}
				return ExtractAt(Ext(ExtUnpackHalf2x16, Pair, Ids), TypeOf(Part), {0});
			});
	}
	const FType* const Int = Types.Scalar(EScalar::Int);
	if (Name.starts_with("pack_"))
	{
		uint32_t Result = Module.Uint(0);
		for (uint32_t c = 0; c < 4; ++c)
		{
			const FType* const Scalar = Types.Scalar(In[0].Type->Scalar);
			uint32_t Part = Convert(Extract(In[0].Id, In[0].Type, c), Scalar, Int);
			if (Name.starts_with("pack_clamp"))
			{
				const bool bSigned = Name.ends_with("s8");
				Part = Ext(
					ExtSClamp, Module.Int(), {Part, Module.Int(bSigned ? -128 : 0), Module.Int(bSigned ? 127 : 255)});
			}
			const uint32_t Byte = Op(OpBitwiseAnd, Uint, {Op(OpBitcast, Uint, {Part}), Module.Uint(255)});
			const uint32_t At = c == 0 ? Byte : Op(OpShiftLeftLogical, Uint, {Byte, Module.Uint(c * 8)});
			Result = Op(OpBitwiseOr, Uint, {Result, At});
		}
		return Result;
	}
	FWords Parts;
	const bool bSigned = Name.starts_with("unpack_s8");
	for (uint32_t c = 0; c < 4; ++c)
	{
		const uint32_t Up = Op(OpShiftLeftLogical, Uint, {In[0].Id, Module.Uint(24 - c * 8)});
		const uint32_t Down =
			bSigned ? Op(OpShiftRightArithmetic, Module.Int(), {Op(OpBitcast, Module.Int(), {Up}), Module.Uint(24)})
					: Op(OpShiftRightLogical, Uint, {Up, Module.Uint(24)});
		Parts.push_back(ConvertScalars(Down, bSigned ? EScalar::Int : EScalar::Uint, Node.Type->Scalar, 1));
	}
	return Construct(TypeOf(Node.Type), Parts);
}

/** msad4, dot2add, dot4add and AddUint64. */
uint32_t FEmitter::Bytes(const FValue& Node, const FArguments& In)
{
	const std::string_view Name = Node.Name;
	const uint32_t Uint = Module.Uint();
	const auto Do2 = [&](uint16_t Opcode, uint32_t A, uint32_t B)
	{
		return Op(Opcode, Uint, {A, B});
	};
	const auto Byte = [&](uint32_t Word, uint32_t i)
	{
		return Do2(OpBitwiseAnd, Do2(OpShiftRightLogical, Word, Module.Uint(i * 8)), Module.Uint(255));
	};
	if (Name == "AddUint64")
	{
		std::vector<FPart> Scalars;
		for (uint32_t i = 0; i < Node.Type->Columns; i += 2)
		{
			const uint32_t A = Extract(In[0].Id, In[0].Type, i);
			const uint32_t Low = Do2(OpIAdd, A, Extract(In[1].Id, In[1].Type, i));
			const uint32_t High =
				Do2(OpIAdd, Extract(In[0].Id, In[0].Type, i + 1), Extract(In[1].Id, In[1].Type, i + 1));
			const uint32_t Carry = Op(OpULessThan, Module.Bool(), {Low, A});
			const uint32_t Sum = Do2(OpIAdd, High, ConvertScalars(Carry, EScalar::Bool, EScalar::Uint, 1));
			Scalars.push_back({Low, Types.Scalar(EScalar::Uint)});
			Scalars.push_back({Sum, Types.Scalar(EScalar::Uint)});
		}
		return Build(Node.Type, Scalars);
	}
	if (Name == "dot2add")
	{
		const FType* const Floats = Types.Vector(EScalar::Float, 2);
		const uint32_t Product = Arithmetic(
			"*", Floats, Convert(In[0].Id, In[0].Type, Floats), Convert(In[1].Id, In[1].Type, Floats), Floats);
		const uint32_t Float = ScalarType(EScalar::Float);
		const uint32_t First = Op(OpFAdd, Float, {In[2].Id, Extract(Product, Floats, 0)});
		return Op(OpFAdd, Float, {First, Extract(Product, Floats, 1)});
	}
	if (Name.starts_with("dot4add"))
	{
		const bool bSigned = Name == "dot4add_i8packed";
		const uint32_t Type = TypeOf(Node.Type);
		uint32_t Sum = In[2].Id;
		const auto Number = [&](uint32_t Word, uint32_t i)
		{
			const uint32_t Up = Op(OpBitcast, Module.Int(), {Do2(OpShiftLeftLogical, Word, Module.Uint(24 - i * 8))});
			return bSigned ? Op(OpShiftRightArithmetic, Module.Int(), {Up, Module.Uint(24)}) : Byte(Word, i);
		};
		for (uint32_t i = 0; i < 4; ++i)
		{
			Sum = Op(OpIAdd, Type, {Sum, Op(OpIMul, Type, {Number(In[0].Id, i), Number(In[1].Id, i)})});
		}
		return Sum;
	}
	// msad4: sums of absolute differences to the reference's bytes that are not 0, at four offsets of a byte.
	FWords Sums;
	const uint32_t Low = Extract(In[1].Id, In[1].Type, 0);
	const uint32_t High = Extract(In[1].Id, In[1].Type, 1);
	for (uint32_t i = 0; i < 4; ++i)
	{
		const uint32_t Source = i == 0 ? Low
									   : Do2(OpBitwiseOr, Do2(OpShiftRightLogical, Low, Module.Uint(i * 8)),
											 Do2(OpShiftLeftLogical, High, Module.Uint(32 - i * 8)));
		uint32_t Sum = Extract(In[2].Id, In[2].Type, i);
		for (uint32_t k = 0; k < 4; ++k)
		{
			const uint32_t A = Byte(In[0].Id, k);
			const uint32_t B = Byte(Source, k);
			const uint32_t Difference = Do2(OpISub, Ext(ExtUMax, Uint, {A, B}), Ext(ExtUMin, Uint, {A, B}));
			const uint32_t Masked = Op(OpIEqual, Module.Bool(), {A, Module.Uint(0)});
			Sum = Do2(OpIAdd, Sum, Op(OpSelect, Uint, {Masked, Module.Uint(0), Difference}));
		}
		Sums.push_back(Sum);
	}
	return Construct(TypeOf(Node.Type), Sums);
}

} // namespace Drydock::Hlsl
