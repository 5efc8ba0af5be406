// Teaches glslang's HLSL front end the numbers of 16 and 64 bits: its tree, its operators and its generator know them
// from GLSL, its HLSL grammar only lacks their names, their constructors and the functions of them. The linker hands
// the calls in which the grammar asks for these to the functions here (--wrap in CMakeLists.txt), which ask glslang's
// own for everything else. Tested against glslang 12; glslang drops HLSL in 17.
#include "FrontEndSamples.h"
#include "FrontEndTree.h"

using namespace Drydock;

namespace
{

struct FTypeName
{
	std::string_view Name;
	TBasicType Type;
};

constexpr FTypeName TypeNames[] = {{"float16_t", EbtFloat16}, {"int16_t", EbtInt16}, {"uint16_t", EbtUint16},
	{"int64_t", EbtInt64}, {"uint64_t", EbtUint64}};

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

/** A thread gets all ones of what is divided by 0; glslang folds literals to other numbers. */
void CorrectDivisionsByZero(TOperator Operator, TIntermTyped* Right, TIntermTyped* Result)
{
	const bool bDivides = Result && (Operator == EOpDiv || Operator == EOpMod);
	if (!bDivides || !Right->getAsConstantUnion() || !Result->getAsConstantUnion())
	{
		return;
	}
	const TConstUnionArray& Divisors = Right->getAsConstantUnion()->getConstArray();
	TConstUnionArray Quotients(Result->getAsConstantUnion()->getConstArray()); // the same numbers, not others
	for (int i = 0; i < Quotients.size(); ++i)
	{
		const TConstUnion& Divisor = Divisors[Divisors.size() == 1 ? 0 : i];
		const TBasicType Type = Result->getBasicType();
		if (Type == EbtInt && Divisor.getIConst() == 0)
		{
			Quotients[i].setIConst(-1);
		}
		else if (Type == EbtUint && Divisor.getUConst() == 0)
		{
			Quotients[i].setUConst(~0u);
		}
		else if (Type == EbtInt64 && Divisor.getI64Const() == 0)
		{
			Quotients[i].setI64Const(-1);
		}
		else if (Type == EbtUint64 && Divisor.getU64Const() == 0)
		{
			Quotients[i].setU64Const(~0ull);
		}
	}
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
	TIntermTyped* const Result = RealAddBinaryMath(Tree, Operator, Left, Right, Place);
	CorrectDivisionsByZero(Operator, Right, Result);
	return Result;
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
	const ESampleForm Form = FindSampleForm(*Function, Nodes);
	if (Form == ESampleForm::Status)
	{
		Context->error(Place, "textures are never tiled here, so there is no status: leave that argument out",
			GetMethodName(*Function), "");
		return nullptr;
	}
	if (Form == ESampleForm::Clamp)
	{
		TIntermAggregate* Others = nullptr;
		for (size_t i = 0; i + 1 < Nodes.size(); ++i)
		{
			Others = Context->intermediate.growAggregate(Others, Nodes[i], Place);
		}
		Made = RealHandleFunctionCall(Context, Place, MakeWithoutLast(*Function), Others);
		if (Made && !AddClamp(Build, Made, Nodes.back()))
		{
			Context->error(Place, "this form of a sample takes no clamp", "Clamp", "");
		}
		return Made;
	}
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
