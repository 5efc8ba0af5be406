// Teaches glslang's HLSL front end the numbers of 16 and 64 bits: its tree, its operators and its generator know them
// from GLSL, its HLSL grammar only lacks their names, their constructors and the functions of them. The linker hands
// the calls in which the grammar asks for these to the functions here (--wrap in CMakeLists.txt), which ask glslang's
// own for everything else. Tested against glslang 12; glslang drops HLSL in 17.
#include <glslang/HLSL/hlslParseHelper.h>
#include <glslang/Include/Types.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace
{

using namespace glslang;

struct FTypeName
{
	std::string_view Name;
	TBasicType Type;
};

constexpr FTypeName TypeNames[] = {{"float16_t", EbtFloat16}, {"int16_t", EbtInt16}, {"uint16_t", EbtUint16},
	{"int64_t", EbtInt64}, {"uint64_t", EbtUint64}};

bool IsNew(TBasicType Type)
{
	return Type == EbtFloat16 || Type == EbtInt16 || Type == EbtUint16 || Type == EbtInt64 || Type == EbtUint64;
}

bool IsReal(TBasicType Type)
{
	return Type == EbtFloat16 || Type == EbtFloat || Type == EbtDouble;
}

bool IsUnsigned(TBasicType Type)
{
	return Type == EbtUint16 || Type == EbtUint || Type == EbtUint64;
}

/** "int64_t", "half" 's relatives "float16_t3" and "uint16_t2x4"; false: another name. */
bool ReadTypeName(std::string_view Name, TType& Type)
{
	for (const FTypeName& Known : TypeNames)
	{
		if (!Name.starts_with(Known.Name))
		{
			continue;
		}
		const std::string_view Rest = Name.substr(Known.Name.size());
		const auto Digit = [Rest](size_t At)
		{
			return Rest[At] >= '1' && Rest[At] <= '4' ? Rest[At] - '0' : 0;
		};
		if (Rest.empty())
		{
			new (&Type) TType(Known.Type, EvqTemporary, 1);
			return true;
		}
		if (Rest.size() == 1 && Digit(0))
		{
			new (&Type) TType(Known.Type, EvqTemporary, Digit(0));
			return true;
		}
		if (Rest.size() == 3 && Digit(0) && Rest[1] == 'x' && Digit(2))
		{
			new (&Type) TType(Known.Type, EvqTemporary, 0, Digit(0), Digit(2));
			return true;
		}
	}
	return false;
}

TOperator GetConversion(TBasicType Type)
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
		TIntermTyped* const Made = Tree.setAggregateOperator(Parts, Tree.mapTypeToConstructorOp(Result), Result, Place);
		TIntermTyped* const Folded = bConstant ? Tree.foldConstructor(Made->getAsAggregate()) : nullptr;
		return Folded ? Folded : Made;
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

TType MakeType(TBasicType Type, const TType& Shape)
{
	return TType(
		Type, EvqTemporary, Shape.getVectorSize(), Shape.getMatrixCols(), Shape.getMatrixRows(), Shape.isVector());
}

/** What a function takes and gives. */
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

constexpr FFunction Functions[] = {{"abs", 1, EOpAbs}, {"sign", 1, EOpSign}, {"min", 2, EOpMin}, {"max", 2, EOpMax},
	{"clamp", 3, EOpClamp}, {"floor", 1, EOpFloor}, {"ceil", 1, EOpCeil}, {"trunc", 1, EOpTrunc},
	{"round", 1, EOpRoundEven}, {"frac", 1, EOpFract}, {"sqrt", 1, EOpSqrt}, {"rsqrt", 1, EOpInverseSqrt},
	{"sin", 1, EOpSin}, {"cos", 1, EOpCos}, {"tan", 1, EOpTan}, {"asin", 1, EOpAsin}, {"acos", 1, EOpAcos},
	{"atan", 1, EOpAtan}, {"atan2", 2, EOpAtan}, {"sinh", 1, EOpSinh}, {"cosh", 1, EOpCosh}, {"tanh", 1, EOpTanh},
	{"exp", 1, EOpExp}, {"exp2", 1, EOpExp2}, {"log", 1, EOpLog}, {"log2", 1, EOpLog2}, {"pow", 2, EOpPow},
	{"lerp", 3, EOpMix}, {"step", 2, EOpStep}, {"smoothstep", 3, EOpSmoothStep}, {"degrees", 1, EOpDegrees},
	{"radians", 1, EOpRadians}, {"fma", 3, EOpFma}, {"normalize", 1, EOpNormalize}, {"cross", 2, EOpCross},
	{"reflect", 2, EOpReflect}, {"faceforward", 3, EOpFaceForward}, {"transpose", 1, EOpTranspose},
	{"reversebits", 1, EOpBitFieldReverse}, {"dot", 2, EOpDot, EForm::Number}, {"length", 1, EOpLength, EForm::Number},
	{"distance", 2, EOpDistance, EForm::Number}, {"determinant", 1, EOpDeterminant, EForm::Number},
	{"isnan", 1, EOpIsNan, EForm::Bools}, {"isinf", 1, EOpIsInf, EForm::Bools}, {"WaveActiveSum", 1, EOpSubgroupAdd},
	{"WaveActiveProduct", 1, EOpSubgroupMul}, {"WaveActiveMin", 1, EOpSubgroupMin},
	{"WaveActiveMax", 1, EOpSubgroupMax}, {"WaveActiveBitAnd", 1, EOpSubgroupAnd},
	{"WaveActiveBitOr", 1, EOpSubgroupOr}, {"WaveActiveBitXor", 1, EOpSubgroupXor},
	{"WavePrefixSum", 1, EOpSubgroupExclusiveAdd}, {"WavePrefixProduct", 1, EOpSubgroupExclusiveMul},
	{"WaveReadLaneFirst", 1, EOpSubgroupBroadcastFirst}, {"QuadReadAcrossX", 1, EOpSubgroupQuadSwapHorizontal},
	{"QuadReadAcrossY", 1, EOpSubgroupQuadSwapVertical}, {"QuadReadAcrossDiagonal", 1, EOpSubgroupQuadSwapDiagonal}};

/** The kind that arguments meet in: a real before an integer, a longer before a shorter one, unsigned before signed. */
TBasicType Meet(const FNodes& Nodes)
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

/** A call of one of HLSL's functions with such numbers among its arguments; null: it is none. */
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
	const TBasicType Type = Meet(Nodes);
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

FNodes GetArguments(const TFunction& Function, TIntermTyped* Arguments)
{
	FNodes Nodes;
	if (Function.getParamCount() == 1 && Arguments)
	{
		return {Arguments};
	}
	TIntermAggregate* const All = Arguments ? Arguments->getAsAggregate() : nullptr;
	for (size_t i = 0; All && i < All->getSequence().size(); ++i)
	{
		TIntermTyped* const Typed = All->getSequence()[i]->getAsTyped();
		if (!Typed)
		{
			return {};
		}
		Nodes.push_back(Typed);
	}
	return Nodes;
}

} // namespace

// Names as the linker has them: HlslParseContext::lookupUserType, handleFunctionCall and declareVariable.
#define DRYDOCK_STRING "NSt7__cxx1112basic_stringIcSt11char_traitsIcENS_14pool_allocatorIcEEEE"
#define DRYDOCK_LOOKUP_USER_TYPE "_ZN7glslang16HlslParseContext14lookupUserTypeERK" DRYDOCK_STRING "RNS_5TTypeE"
#define DRYDOCK_HANDLE_FUNCTION_CALL \
	"_ZN7glslang16HlslParseContext18handleFunctionCallERKNS_10TSourceLocEPNS_9TFunctionEPNS_12TIntermTypedE"
#define DRYDOCK_HANDLE_ASSIGN \
	"_ZN7glslang16HlslParseContext12handleAssignERKNS_10TSourceLocENS_9TOperatorEPNS_12TIntermTypedES6_"
#define DRYDOCK_ADD_BINARY_MATH \
	"_ZN7glslang13TIntermediate13addBinaryMathENS_9TOperatorEPNS_12TIntermTypedES3_RKNS_10TSourceLocE"
#define DRYDOCK_DECLARE_VARIABLE \
	"_ZN7glslang16HlslParseContext15declareVariableERKNS_10TSourceLocERK" DRYDOCK_STRING \
	"RNS_5TTypeEPNS_12TIntermTypedE"

TSymbol* RealLookupUserType(HlslParseContext*, const TString&, TType&) asm("__real_" DRYDOCK_LOOKUP_USER_TYPE);
TSymbol* WrapLookupUserType(HlslParseContext*, const TString&, TType&) asm("__wrap_" DRYDOCK_LOOKUP_USER_TYPE);
TIntermTyped* RealHandleFunctionCall(HlslParseContext*, const TSourceLoc&, TFunction*, TIntermTyped*) asm(
	"__real_" DRYDOCK_HANDLE_FUNCTION_CALL);
TIntermTyped* WrapHandleFunctionCall(HlslParseContext*, const TSourceLoc&, TFunction*, TIntermTyped*) asm(
	"__wrap_" DRYDOCK_HANDLE_FUNCTION_CALL);
TIntermNode* RealDeclareVariable(HlslParseContext*, const TSourceLoc&, const TString&, TType&, TIntermTyped*) asm(
	"__real_" DRYDOCK_DECLARE_VARIABLE);
TIntermNode* WrapDeclareVariable(HlslParseContext*, const TSourceLoc&, const TString&, TType&, TIntermTyped*) asm(
	"__wrap_" DRYDOCK_DECLARE_VARIABLE);

TIntermTyped* RealHandleAssign(HlslParseContext*, const TSourceLoc&, TOperator, TIntermTyped*, TIntermTyped*) asm(
	"__real_" DRYDOCK_HANDLE_ASSIGN);
TIntermTyped* WrapHandleAssign(HlslParseContext*, const TSourceLoc&, TOperator, TIntermTyped*, TIntermTyped*) asm(
	"__wrap_" DRYDOCK_HANDLE_ASSIGN);
TIntermTyped* RealAddBinaryMath(TIntermediate*, TOperator, TIntermTyped*, TIntermTyped*, const TSourceLoc&) asm(
	"__real_" DRYDOCK_ADD_BINARY_MATH);
TIntermTyped* WrapAddBinaryMath(TIntermediate*, TOperator, TIntermTyped*, TIntermTyped*, const TSourceLoc&) asm(
	"__wrap_" DRYDOCK_ADD_BINARY_MATH);

namespace
{

/** Two numbers of which one is of these kinds and the other of another. */
bool NeedConversion(TIntermTyped* A, TIntermTyped* B)
{
	const auto IsNumber = [](TIntermTyped* Node)
	{
		return Node && !Node->isArray() && !Node->isStruct() && Node->getBasicType() <= EbtBool &&
			   Node->getBasicType() != EbtVoid;
	};
	return IsNumber(A) && IsNumber(B) && A->getBasicType() != B->getBasicType() &&
		   (IsNew(A->getBasicType()) || IsNew(B->getBasicType()));
}

} // namespace

TIntermTyped* WrapHandleAssign(
	HlslParseContext* Context, const TSourceLoc& Place, TOperator Operator, TIntermTyped* Left, TIntermTyped* Right)
{
	const FBuilder Build(Context->intermediate, Place);
	TIntermTyped* const Made = NeedConversion(Left, Right) ? Build.Convert(Left->getBasicType(), Right) : nullptr;
	return RealHandleAssign(Context, Place, Operator, Left, Made ? Made : Right);
}

TIntermTyped* WrapAddBinaryMath(
	TIntermediate* Tree, TOperator Operator, TIntermTyped* Left, TIntermTyped* Right, const TSourceLoc& Place)
{
	if (NeedConversion(Left, Right))
	{
		const FBuilder Build(*Tree, Place);
		const bool bShift = Operator == EOpLeftShift || Operator == EOpRightShift;
		const TBasicType Type = bShift ? Left->getBasicType() : Meet({Left, Right});
		TIntermTyped* const A = Build.Convert(Type, Left);
		TIntermTyped* const B = Build.Convert(Type, Right);
		return RealAddBinaryMath(Tree, Operator, A ? A : Left, B ? B : Right, Place);
	}
	return RealAddBinaryMath(Tree, Operator, Left, Right, Place);
}

TSymbol* WrapLookupUserType(HlslParseContext* Context, const TString& Name, TType& Type)
{
	TSymbol* const Own = RealLookupUserType(Context, Name, Type);
	return !Own && ReadTypeName(Name.c_str(), Type) ? new TVariable(NewPoolTString(Name.c_str()), Type, true) : Own;
}

TIntermTyped* WrapHandleFunctionCall(
	HlslParseContext* Context, const TSourceLoc& Place, TFunction* Function, TIntermTyped* Arguments)
{
	const FBuilder Build(Context->intermediate, Place);
	const FNodes Nodes = GetArguments(*Function, Arguments);
	TIntermTyped* Made = nullptr;
	const TType& Type = Function->getType();
	const bool bNew = IsNew(Type.getBasicType()) || std::any_of(Nodes.begin(), Nodes.end(),
														[](TIntermTyped* Node) { return IsNew(Node->getBasicType()); });
	if (!Nodes.empty() && Function->getBuiltInOp() != EOpNull && bNew)
	{
		const bool bNumbers = !Type.isArray() && !Type.isStruct();
		Made = bNumbers ? Build.Construct(Type, Nodes) : nullptr;
	}
	else if (!Nodes.empty() && Function->getBuiltInOp() == EOpNull)
	{
		Made = MakeCall(Build, Function->getName().c_str(), Nodes);
	}
	return Made ? Made : RealHandleFunctionCall(Context, Place, Function, Arguments);
}

TIntermNode* WrapDeclareVariable(
	HlslParseContext* Context, const TSourceLoc& Place, const TString& Name, TType& Type, TIntermTyped* Initial)
{
	const FBuilder Build(Context->intermediate, Place);
	TIntermAggregate* const List = Initial ? Initial->getAsAggregate() : nullptr;
	if (List && List->getOp() == EOpNull && IsNew(Type.getBasicType()))
	{
		FNodes Nodes;
		for (TIntermNode* const Node : List->getSequence())
		{
			Nodes.push_back(Node->getAsTyped());
		}
		const bool bFlat =
			!Nodes.empty() &&
			std::all_of(Nodes.begin(), Nodes.end(),
				[](TIntermTyped* Node)
				{ return Node && !(Node->getAsAggregate() && Node->getAsAggregate()->getOp() == EOpNull); });
		if (bFlat && !Type.isArray())
		{
			TIntermTyped* const Made = Build.Construct(Type, Nodes);
			return RealDeclareVariable(Context, Place, Name, Type, Made ? Made : Initial);
		}
		const bool bElements = bFlat && !Type.isVector() && !Type.isMatrix();
		for (size_t i = 0; bElements && i < Nodes.size(); ++i)
		{
			TIntermTyped* const Made = Build.Convert(Type.getBasicType(), Nodes[i]);
			List->getSequence()[i] = Made ? Made : Nodes[i];
		}
	}
	const bool bNumber = Initial && !List && !Type.isArray() && !Type.isStruct() && !Initial->isArray() &&
						 !Initial->isStruct() && Type.getBasicType() != Initial->getBasicType();
	if (bNumber && (IsNew(Type.getBasicType()) || IsNew(Initial->getBasicType())))
	{
		TIntermTyped* const Made = Build.Convert(Type.getBasicType(), Initial);
		Initial = Made ? Made : Initial;
	}
	return RealDeclareVariable(Context, Place, Name, Type, Initial);
}
