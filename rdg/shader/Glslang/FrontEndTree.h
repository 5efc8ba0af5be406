// Builds nodes of glslang's tree of numbers of any kind, those of 16 and 64 bits among them.
#pragma once

#include <glslang/HLSL/hlslParseHelper.h>
#include <glslang/Include/Types.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace Drydock
{

using namespace glslang;

/** True for types that glslang's HLSL grammar has no name for. */
inline bool IsNew(TBasicType Type)
{
	return Type == EbtFloat16 || Type == EbtInt16 || Type == EbtUint16 || Type == EbtInt64 || Type == EbtUint64;
}

inline bool IsReal(TBasicType Type)
{
	return Type == EbtFloat16 || Type == EbtFloat || Type == EbtDouble;
}

inline bool IsUnsigned(TBasicType Type)
{
	return Type == EbtUint16 || Type == EbtUint || Type == EbtUint64;
}

inline TOperator GetConversion(TBasicType Type)
{
	switch (Type)
	{
	case EbtFloat16:
		return EOpConstructFloat16;
	case EbtInt16:
		return EOpConstructInt16;
	case EbtUint16:
		return EOpConstructUint16;
	case EbtInt64:
		return EOpConstructInt64;
	case EbtUint64:
		return EOpConstructUint64;
	case EbtFloat:
		return EOpConstructFloat;
	case EbtDouble:
		return EOpConstructDouble;
	case EbtUint:
		return EOpConstructUint;
	case EbtInt:
		return EOpConstructInt;
	default:
		return EOpConstructBool;
	}
}

using FNodes = std::vector<TIntermTyped*>;

class FBuilder
{
public:
	FBuilder(TIntermediate& InTree, const TSourceLoc& InPlace)
		: Tree(InTree)
		, Place(InPlace)
	{
	}

	/** The same components as numbers of another kind; null where that cannot be. */
	TIntermTyped* Convert(TBasicType Type, TIntermTyped* Node, int Depth = 0) const
	{
		const TBasicType From = Node->getBasicType();
		if (From == Type)
		{
			return Node;
		}
		TIntermTyped* Made = Tree.addUnaryMath(GetConversion(Type), Node, Place);
		// The tree has no way from all to all: a float holds each float16_t, an int each integer of 16 bits.
		const bool bReal = Type == EbtFloat16 || From == EbtFloat16;
		for (const TOperator By :
			{bReal ? EOpConstructFloat : EOpConstructInt, bReal ? EOpConstructInt : EOpConstructFloat})
		{
			TIntermTyped* const Between = Made || Depth > 2 ? nullptr : Tree.addUnaryMath(By, Node, Place);
			if (Between && Between->getBasicType() != From)
			{
				Made = Convert(Type, Between, Depth + 1);
			}
		}
		return Made;
	}

	/** A value of Type made of all components of the nodes, or of one for all. */
	TIntermTyped* Construct(const TType& Type, const FNodes& Nodes) const
	{
		TIntermAggregate* Parts = nullptr;
		bool bConstant = true;
		TIntermTyped* Last = nullptr;
		for (TIntermTyped* const Node : Nodes)
		{
			if (Node->isArray() || Node->isStruct())
			{
				return nullptr;
			}
			Last = Convert(Type.getBasicType(), Node);
			if (!Last)
			{
				return nullptr;
			}
			bConstant = bConstant && Last->getAsConstantUnion();
			Parts = Tree.growAggregate(Parts, Last, Place);
		}
		const bool bSame = Nodes.size() == 1 && Last->getVectorSize() == Type.getVectorSize() &&
						   Last->getMatrixCols() == Type.getMatrixCols() &&
						   Last->getMatrixRows() == Type.getMatrixRows() && Last->isVector() == Type.isVector();
		if (!Last || bSame)
		{
			return Last;
		}
		TType Result(Type.getBasicType(), bConstant ? EvqConst : EvqTemporary, Type.getVectorSize(),
			Type.getMatrixCols(), Type.getMatrixRows(), Type.isVector());
		return Tree.setAggregateOperator(Parts, Tree.mapTypeToConstructorOp(Result), Result, Place); // folds constants
	}

	TIntermTyped* Constant(TBasicType Type, double Value) const
	{
		return Convert(Type, Tree.addConstantUnion(Value, EbtFloat, Place, true));
	}

	TIntermTyped* Binary(TOperator Operator, TIntermTyped* A, TIntermTyped* B) const
	{
		return Tree.addBinaryMath(Operator, A, B, Place);
	}

	TIntermTyped* Call(TOperator Operator, const FNodes& Nodes, const TType& Result) const
	{
		if (Nodes.size() == 1)
		{
			return Tree.addBuiltInFunctionCall(Place, Operator, true, Nodes[0], Result);
		}
		TIntermAggregate* Arguments = nullptr;
		for (TIntermTyped* const Node : Nodes)
		{
			Arguments = Tree.growAggregate(Arguments, Node, Place);
		}
		return Tree.addBuiltInFunctionCall(Place, Operator, false, Arguments, Result);
	}

	TIntermediate& Tree;
	const TSourceLoc& Place;
};

inline TType MakeType(TBasicType Type, const TType& Shape)
{
	return TType(
		Type, EvqTemporary, Shape.getVectorSize(), Shape.getMatrixCols(), Shape.getMatrixRows(), Shape.isVector());
}

/** The kind that arguments meet in: a real before an integer, a longer before a shorter one, unsigned before signed. */
inline TBasicType Meet(const FNodes& Nodes)
{
	const auto Rank = [](TBasicType Type)
	{
		constexpr TBasicType Order[] = {
			EbtBool, EbtInt16, EbtUint16, EbtInt, EbtUint, EbtInt64, EbtUint64, EbtFloat16, EbtFloat, EbtDouble};
		return std::find(std::begin(Order), std::end(Order), Type) - std::begin(Order);
	};
	TBasicType Result = Nodes[0]->getBasicType();
	for (TIntermTyped* const Node : Nodes)
	{
		// A literal takes the type of the others: they came to stand beside it.
		const bool bLiteral = Node->getAsConstantUnion() && !IsNew(Node->getBasicType());
		const bool bOtherLiteral = Result == EbtInt || Result == EbtFloat;
		Result = (!bLiteral && Rank(Node->getBasicType()) > Rank(Result)) ||
						 (bOtherLiteral && IsNew(Node->getBasicType()) && Nodes[0]->getAsConstantUnion())
					 ? Node->getBasicType()
					 : Result;
	}
	return Result;
}

/** A call of one of HLSL's functions with such numbers among its arguments; null: it is none. */
TIntermTyped* MakeCall(const FBuilder& Build, std::string_view Name, FNodes Nodes);

} // namespace Drydock
