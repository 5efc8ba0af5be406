// HLSL's functions of the numbers of 16 and 64 bits, as nodes of glslang's tree.
#include "FrontEndTree.h"

namespace Drydock
{

namespace
{

/** The form of a function: its arguments and its result. */
enum class EForm
{
	Each,   // all arguments and the result alike
	Number, // of the vectors, one number
	Bools   // a bool for each component
};

struct FFunction
{
	std::string_view Name;
	size_t NumArguments;
	TOperator Operator;
	EForm Form = EForm::Each;
};

constexpr FFunction Functions[] = {{"abs", 1, EOpAbs}, {"min", 2, EOpMin}, {"max", 2, EOpMax}, {"clamp", 3, EOpClamp},
	{"floor", 1, EOpFloor}, {"ceil", 1, EOpCeil}, {"trunc", 1, EOpTrunc}, {"round", 1, EOpRoundEven},
	{"frac", 1, EOpFract}, {"sqrt", 1, EOpSqrt}, {"rsqrt", 1, EOpInverseSqrt}, {"sin", 1, EOpSin}, {"cos", 1, EOpCos},
	{"tan", 1, EOpTan}, {"asin", 1, EOpAsin}, {"acos", 1, EOpAcos}, {"atan", 1, EOpAtan}, {"atan2", 2, EOpAtan},
	{"sinh", 1, EOpSinh}, {"cosh", 1, EOpCosh}, {"tanh", 1, EOpTanh}, {"exp", 1, EOpExp}, {"exp2", 1, EOpExp2},
	{"log", 1, EOpLog}, {"log2", 1, EOpLog2}, {"pow", 2, EOpPow}, {"lerp", 3, EOpMix}, {"step", 2, EOpStep},
	{"smoothstep", 3, EOpSmoothStep}, {"degrees", 1, EOpDegrees}, {"radians", 1, EOpRadians}, {"fma", 3, EOpFma},
	{"normalize", 1, EOpNormalize}, {"cross", 2, EOpCross}, {"reflect", 2, EOpReflect},
	{"faceforward", 3, EOpFaceForward}, {"transpose", 1, EOpTranspose}, {"reversebits", 1, EOpBitFieldReverse},
	{"dot", 2, EOpDot, EForm::Number}, {"length", 1, EOpLength, EForm::Number},
	{"distance", 2, EOpDistance, EForm::Number}, {"determinant", 1, EOpDeterminant, EForm::Number},
	{"isnan", 1, EOpIsNan, EForm::Bools}, {"isinf", 1, EOpIsInf, EForm::Bools}, {"WaveActiveSum", 1, EOpSubgroupAdd},
	{"WaveActiveProduct", 1, EOpSubgroupMul}, {"WaveActiveMin", 1, EOpSubgroupMin},
	{"WaveActiveMax", 1, EOpSubgroupMax}, {"WaveActiveBitAnd", 1, EOpSubgroupAnd},
	{"WaveActiveBitOr", 1, EOpSubgroupOr}, {"WaveActiveBitXor", 1, EOpSubgroupXor},
	{"WavePrefixSum", 1, EOpSubgroupExclusiveAdd}, {"WavePrefixProduct", 1, EOpSubgroupExclusiveMul},
	{"WaveReadLaneFirst", 1, EOpSubgroupBroadcastFirst}, {"QuadReadAcrossX", 1, EOpSubgroupQuadSwapHorizontal},
	{"QuadReadAcrossY", 1, EOpSubgroupQuadSwapVertical}, {"QuadReadAcrossDiagonal", 1, EOpSubgroupQuadSwapDiagonal}};

/** All nodes as Type in the widest shape of them. */
bool MakeAlike(const FBuilder& Build, TBasicType Type, FNodes& Nodes)
{
	TIntermTyped* const Widest = *std::max_element(Nodes.begin(), Nodes.end(),
		[](TIntermTyped* A, TIntermTyped* B)
		{ return A->getType().computeNumComponents() < B->getType().computeNumComponents(); });
	const TType Shape = MakeType(Type, Widest->getType());
	for (TIntermTyped*& Node : Nodes)
	{
		Node = Build.Construct(Shape, {Node});
		if (!Node)
		{
			return false;
		}
	}
	return true;
}

/** Component i of a vector, or a scalar. */
TIntermTyped* Pick(const FBuilder& Build, TIntermTyped* Node, int i)
{
	if (!Node->isVector())
	{
		return Node;
	}
	TIntermTyped* const Part =
		Build.Tree.addIndex(EOpIndexDirect, Node, Build.Tree.addConstantUnion(i, Build.Place), Build.Place);
	Part->setType(TType(Node->getBasicType(), EvqTemporary));
	return Part;
}

/** a0 * b0 + a1 * b1 + ... of integers. */
TIntermTyped* MakeIntegerDot(const FBuilder& Build, TIntermTyped* A, TIntermTyped* B)
{
	TIntermTyped* const Products = Build.Binary(EOpMul, A, B);
	TIntermTyped* Sum = nullptr;
	for (int i = 0; Products && i < Products->getVectorSize(); ++i)
	{
		TIntermTyped* const Part = Pick(Build, Products, i);
		Sum = Sum ? Build.Binary(EOpAdd, Sum, Part) : Part;
	}
	return Sum;
}

/** Functions that are an expression of others. Null: none of these. */
TIntermTyped* MakeExpression(const FBuilder& Build, std::string_view Name, FNodes Nodes, TBasicType Type)
{
	const TType Shape = MakeType(Type, Nodes[0]->getType());
	const size_t Count = Nodes.size();
	if (Name == "rcp" && Count == 1)
	{
		return Build.Binary(EOpDiv, Build.Constant(Type, 1), Nodes[0]);
	}
	if (Name == "saturate" && Count == 1)
	{
		FNodes All = {Nodes[0], Build.Constant(Type, 0), Build.Constant(Type, 1)};
		return MakeAlike(Build, Type, All) ? Build.Call(EOpClamp, All, Shape) : nullptr;
	}
	if (Name == "log10" && Count == 1)
	{
		return Build.Binary(EOpMul, Build.Call(EOpLog2, Nodes, Shape), Build.Constant(Type, 0.30102999566398120));
	}
	if (Name == "fmod" && Count == 2)
	{
		return MakeAlike(Build, Type, Nodes) ? Build.Call(EOpMod, Nodes, Nodes[0]->getType()) : nullptr;
	}
	if (Name == "ldexp" && Count == 2)
	{
		TIntermTyped* const Power = Build.Call(EOpExp2, {Build.Convert(Type, Nodes[1])}, Shape);
		return Build.Binary(EOpMul, Nodes[0], Power);
	}
	if (Name == "mad" && Count == 3 && MakeAlike(Build, Type, Nodes))
	{
		return IsReal(Type) ? Build.Call(EOpFma, Nodes, Nodes[0]->getType())
							: Build.Binary(EOpAdd, Build.Binary(EOpMul, Nodes[0], Nodes[1]), Nodes[2]);
	}
	if ((Name == "any" || Name == "all") && Count == 1)
	{
		TIntermTyped* const Bools = Build.Convert(EbtBool, Nodes[0]);
		return Bools && Bools->isVector() ? Build.Call(Name == "any" ? EOpAny : EOpAll, {Bools}, TType(EbtBool))
										  : Bools;
	}
	if (Name == "countbits" && Count == 1)
	{
		const TType Result = MakeType(EbtUint, Shape);
		if (Type == EbtInt64 || Type == EbtUint64)
		{
			const TType Long = MakeType(EbtUint64, Shape);
			return Build.Convert(EbtUint, Build.Call(EOpBitCount, {Build.Convert(EbtUint64, Nodes[0])}, Long));
		}
		TIntermTyped* const Bits = Build.Convert(EbtUint, Build.Convert(EbtUint16, Nodes[0]));
		return Build.Call(EOpBitCount, {Bits}, Result);
	}
	if ((Name == "firstbithigh" || Name == "firstbitlow") && Count == 1)
	{
		const bool bLong = Type == EbtInt64 || Type == EbtUint64;
		const TBasicType Wide = bLong ? Type : IsUnsigned(Type) ? EbtUint : EbtInt;
		TIntermTyped* const Bits = Build.Convert(Wide, Nodes[0]);
		return Build.Convert(
			EbtUint, Build.Call(Name == "firstbithigh" ? EOpFindMSB : EOpFindLSB, {Bits}, MakeType(Wide, Shape)));
	}
	if (Name == "mul" && Count == 2)
	{
		TIntermTyped* const A = Build.Convert(Type, Nodes[0]);
		TIntermTyped* const B = Build.Convert(Type, Nodes[1]);
		if (A->isVector() && B->isVector())
		{
			return IsReal(Type) ? Build.Call(EOpDot, {A, B}, TType(Type)) : MakeIntegerDot(Build, A, B);
		}
		// HLSL's rows are the tree's columns: the operands change places.
		return A->isMatrix() || B->isMatrix() ? Build.Binary(EOpMul, B, A) : Build.Binary(EOpMul, A, B);
	}
	if (Count == 1 && (Name == "asfloat16" || Name == "asint16" || Name == "asuint16"))
	{
		const TBasicType To = Name == "asfloat16" ? EbtFloat16 : Name == "asint16" ? EbtInt16 : EbtUint16;
		if (Type == To || (Type != EbtFloat16 && To != EbtFloat16))
		{
			return Build.Convert(To, Nodes[0]);
		}
		const TOperator Operator = Type == EbtFloat16
									   ? (To == EbtInt16 ? EOpFloat16BitsToInt16 : EOpFloat16BitsToUint16)
								   : Type == EbtInt16 ? EOpInt16BitsToFloat16
													  : EOpUint16BitsToFloat16;
		return Build.Call(Operator, Nodes, MakeType(To, Shape));
	}
	if (Count == 2 && (Name == "WaveReadLaneAt" || Name == "QuadReadLaneAt"))
	{
		return Build.Call(Name == "WaveReadLaneAt" ? EOpSubgroupShuffle : EOpSubgroupQuadBroadcast,
			{Nodes[0], Build.Convert(EbtUint, Nodes[1])}, Shape);
	}
	return nullptr;
}

struct FAtomic
{
	std::string_view Name;
	TOperator Operator;
	size_t NumArguments; // with the number in memory, without what is given back
};

constexpr FAtomic Atomics[] = {{"InterlockedAdd", EOpAtomicAdd, 2}, {"InterlockedAnd", EOpAtomicAnd, 2},
	{"InterlockedOr", EOpAtomicOr, 2}, {"InterlockedXor", EOpAtomicXor, 2}, {"InterlockedMin", EOpAtomicMin, 2},
	{"InterlockedMax", EOpAtomicMax, 2}, {"InterlockedExchange", EOpAtomicExchange, 2},
	{"InterlockedCompareExchange", EOpAtomicCompSwap, 3}};

/** Interlocked* of a number of 64 bits; what was there before is assigned to a last argument. */
TIntermTyped* MakeAtomic(const FBuilder& Build, const FAtomic& Atomic, const FNodes& Nodes)
{
	const bool bGivesBack = Nodes.size() == Atomic.NumArguments + 1;
	if (!bGivesBack && Nodes.size() != Atomic.NumArguments)
	{
		return nullptr;
	}
	const TType Type(Nodes[0]->getBasicType());
	TIntermAggregate* const Made = new TIntermAggregate(Atomic.Operator);
	Made->getSequence().push_back(Nodes[0]);
	for (size_t i = 1; i < Atomic.NumArguments; ++i)
	{
		TIntermTyped* const Value = Build.Construct(Type, {Nodes[i]});
		if (!Value)
		{
			return nullptr;
		}
		Made->getSequence().push_back(Value);
	}
	Made->setType(Type);
	Made->setLoc(Build.Place);
	TIntermTyped* const Before = bGivesBack ? Build.Convert(Nodes.back()->getBasicType(), Made) : nullptr;
	return Before ? Build.Tree.addAssign(EOpAssign, Nodes.back(), Before, Build.Place) : Made;
}

/** sign, which is an int of all types. */
TIntermTyped* MakeSign(const FBuilder& Build, TIntermTyped* X)
{
	const TBasicType Type = X->getBasicType();
	const TType Shape = MakeType(Type, X->getType());
	TIntermTyped* const Sign = IsUnsigned(Type)
								   ? Build.Call(EOpMin, {X, Build.Construct(Shape, {Build.Constant(Type, 1)})}, Shape)
								   : Build.Call(EOpSign, {X}, Shape);
	return Build.Convert(EbtInt, Sign);
}

/** refract(I, N, Ratio): vectors and one number. */
TIntermTyped* MakeRefract(const FBuilder& Build, FNodes Nodes, TBasicType Type)
{
	FNodes Vectors = {Nodes[0], Nodes[1]};
	TIntermTyped* const Ratio = Build.Construct(TType(Type), {Nodes[2]});
	return Ratio && MakeAlike(Build, Type, Vectors)
			   ? Build.Call(EOpRefract, {Vectors[0], Vectors[1], Ratio}, Vectors[0]->getType())
			   : nullptr;
}

/** asdouble(Low, High), component by component. */
TIntermTyped* MakeDouble(const FBuilder& Build, TIntermTyped* Low, TIntermTyped* High)
{
	FNodes Parts;
	for (int i = 0; i < Low->getVectorSize(); ++i)
	{
		const TType Pair(EbtUint, EvqTemporary, 2);
		TIntermTyped* const Bits = Build.Construct(Pair, {Pick(Build, Low, i), Pick(Build, High, i)});
		Parts.push_back(Build.Call(EOpPackDouble2x32, {Bits}, TType(EbtDouble)));
	}
	return Build.Construct(MakeType(EbtDouble, Low->getType()), Parts);
}

/** WaveActiveAllEqual: a bool for each component. */
TIntermTyped* MakeAllEqual(const FBuilder& Build, TIntermTyped* X)
{
	FNodes Parts;
	for (int i = 0; i < X->getVectorSize(); ++i)
	{
		Parts.push_back(Build.Call(EOpSubgroupAllEqual, {Pick(Build, X, i)}, TType(EbtBool)));
	}
	return Build.Construct(MakeType(EbtBool, X->getType()), Parts);
}

/** asuint(X, out Low, out High): two assignments. */
TIntermTyped* SplitDouble(const FBuilder& Build, TIntermTyped* X, TIntermTyped* Low, TIntermTyped* High)
{
	FNodes Words[2];
	for (int i = 0; i < X->getVectorSize(); ++i)
	{
		TIntermTyped* const Pair =
			Build.Call(EOpUnpackDouble2x32, {Pick(Build, X, i)}, TType(EbtUint, EvqTemporary, 2));
		Words[0].push_back(Pick(Build, Pair, 0));
		Words[1].push_back(Pick(Build, Pair, 1));
	}
	const TType Shape = MakeType(EbtUint, X->getType());
	TIntermTyped* const First = Build.Tree.addAssign(EOpAssign, Low, Build.Construct(Shape, Words[0]), Build.Place);
	TIntermTyped* const Second = Build.Tree.addAssign(EOpAssign, High, Build.Construct(Shape, Words[1]), Build.Place);
	return First && Second ? Build.Tree.addComma(First, Second, Build.Place) : nullptr;
}

} // namespace

TIntermTyped* MakeCall(const FBuilder& Build, std::string_view Name, FNodes Nodes)
{
	bool bNew = false;
	for (TIntermTyped* const Node : Nodes)
	{
		if (Node->isArray() || Node->isStruct() || Node->getBasicType() > EbtBool)
		{
			return nullptr;
		}
		bNew = bNew || IsNew(Node->getBasicType()) || Node->getBasicType() == EbtDouble;
	}
	const bool bPair =
		Nodes.size() == 2 && Name == "asdouble" && Nodes[0]->getVectorSize() == Nodes[1]->getVectorSize();
	if (bPair && !Nodes[0]->isMatrix())
	{
		return MakeDouble(Build, Nodes[0], Nodes[1]);
	}
	if (!bNew)
	{
		return nullptr;
	}
	if (Name == "asuint" && Nodes.size() == 3 && Nodes[0]->getBasicType() == EbtDouble && !Nodes[0]->isMatrix())
	{
		return SplitDouble(Build, Nodes[0], Nodes[1], Nodes[2]);
	}
	const bool bLong = Nodes[0]->getBasicType() == EbtInt64 || Nodes[0]->getBasicType() == EbtUint64;
	for (const FAtomic& Atomic : Atomics)
	{
		if (bLong && Atomic.Name == Name)
		{
			return MakeAtomic(Build, Atomic, Nodes);
		}
	}
	const TBasicType Type = Meet(Nodes);
	if (Name == "sign" && Nodes.size() == 1)
	{
		return MakeSign(Build, Nodes[0]);
	}
	if (Name == "WaveActiveAllEqual" && Nodes.size() == 1 && !Nodes[0]->isMatrix())
	{
		return MakeAllEqual(Build, Nodes[0]);
	}
	if (Name == "refract" && Nodes.size() == 3)
	{
		return MakeRefract(Build, Nodes, Type);
	}
	if (TIntermTyped* const Made = MakeExpression(Build, Name, Nodes, Type))
	{
		return Made;
	}
	for (const FFunction& Function : Functions)
	{
		if (Function.Name != Name || Function.NumArguments != Nodes.size() || !MakeAlike(Build, Type, Nodes))
		{
			continue;
		}
		if (Function.Operator == EOpDot && (!IsReal(Type) || !Nodes[0]->isVector()))
		{
			return MakeIntegerDot(Build, Nodes[0], Nodes[1]);
		}
		if (Function.Operator == EOpAbs && IsUnsigned(Type))
		{
			return Nodes[0];
		}
		const TType& Shape = Nodes[0]->getType();
		if (Function.Operator == EOpTranspose)
		{
			const TType Turned(Type, EvqTemporary, 0, Shape.getMatrixRows(), Shape.getMatrixCols());
			return Build.Call(Function.Operator, Nodes, Turned);
		}
		const TType Result = Function.Form == EForm::Number
								 ? TType(Type)
								 : MakeType(Function.Form == EForm::Bools ? EbtBool : Type, Shape);
		return Build.Call(Function.Operator, Nodes, Result);
	}
	return nullptr;
}

} // namespace Drydock
