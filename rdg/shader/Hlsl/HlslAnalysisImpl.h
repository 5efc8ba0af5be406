// The state of one analysis, which the files of the analysis share.
#pragma once

#include "HlslAnalysis.h"
#include "HlslConstants.h"
#include "HlslConversions.h"
#include "HlslIntrinsics.h"
#include "HlslSymbols.h"
#include "HlslTree.h"

#include <deque>
#include <map>
#include <set>
#include <unordered_map>

namespace Drydock::Hlsl
{

/** The place that the analysis is at. */
struct FPosition
{
	FNameScope* Scope = nullptr;
	FFunction* Function = nullptr;
	FOverload* Overload = nullptr;
	FVariable* This = nullptr;
	uint32_t Order = 0;
	int NumLoops = 0;
	int NumSwitches = 0;
	bool bSwitch = false;                // what stands around it next is a switch, not a loop
	bool bBreaks = false;                // a break for the innermost loop or switch was found
	bool bStatic = false;                // an initializer that is run before the entry
	std::vector<FCode*>* Code = nullptr; // where temporaries are declared
};

/** The arguments of a call. Those that are lists get their type from the parameter. */
struct FArguments
{
	std::vector<FValue*> Values; // null: a list
	std::vector<const FExpression*> Trees;
	bool bBad = false;
};

inline constexpr int MaxValueDepth = 1400;
inline constexpr int MaxTemplateDepth = 64;
inline constexpr int MaxInstances = 4096;
inline constexpr uint64_t MaxLeaves = 1u << 20;
inline constexpr size_t MaxMessages = 20;

/** Static storage for the text of an operator. */
std::string_view KeepOperator(std::string_view Operator);

/** Scalars and objects in a type. */
uint64_t CountLeaves(const FType* Type);

/** Whether all that the value depends on is constant. */
bool IsKnown(const FValue& Value);

inline bool IsError(const FValue* Value)
{
	return Value->Type->Kind == EType::Error;
}

class FAnalyser
{
public:
	FAnalyser(const FTree& InTree, const FAnalysisOptions& InOptions);

	FAnalysis Run();

private:
	// HlslAnalysis.cpp: messages, the order of the program
	void Error(const FPlace& Place, const std::string& Message, int Code = 6010);
	void Warn(const FPlace& Place, const std::string& Message);
	FValue* Fail(const FPlace& Place, const std::string& Message);
	void Say(ESeverity Severity, const FPlace& Place, const std::string& Message, int Code);
	std::vector<FDiagnostic> TakeMessages(ESeverity Severity);
	void AnalyseBody(FFunction& Function, FOverload& Overload);
	void WarnOfUnset();
	void CheckRegisters(const FVariable& Variable, const FDeclaration& Declaration);
	void OrderFunctions();
	void VisitCalls(FFunction* Root, std::map<const FFunction*, int>& State);
	void Finish();
	void LayOut(FBuffer& Buffer);

	// HlslScopes.cpp
	FNameScope* MakeScope(EScopeKind Kind, FNameScope* Parent, const std::string& Name = {});
	void EnterAll(
		const std::vector<FDeclaration*>& Declarations, FNameScope& Scope, const FDeclaration* Buffer = nullptr);
	void EnterOne(const FDeclaration& Declaration, FNameScope& Scope, const FDeclaration* Buffer);
	void EnterType(const FTypeName* Type, FNameScope& Scope);
	void EnterStruct(const FStruct& Struct, const FDeclaration* Declaration, FNameScope& Scope);
	void EnterEnum(const FEnum& Enum, FNameScope& Scope);
	void EnterFunction(const FDeclaration& Declaration, FNameScope& Scope);
	void EnterNamespace(const FDeclaration& Declaration, FNameScope& Scope);
	void EnterOutside();
	FSymbol* Add(FNameScope& Scope, std::string_view Name, ESymbol Kind, const FPlace& Place);
	bool Redefine(const FSymbol& Old, const FPlace& Place);
	bool IsVisible(const FSymbol& Symbol) const;
	FSymbol* FindIn(FNameScope& Scope, std::string_view Name, FNameScope** Where = nullptr);
	FSymbol* FindUsed(FNameScope& Scope, std::string_view Name, FNameScope** Where);
	FSymbol* FindName(std::string_view Name, FNameScope** Where = nullptr);
	FSymbol* FindQualified(const FName& Name, FNameScope** Where = nullptr);
	FNameScope* FindScopeOf(const FSymbol& Symbol, const FNamePart& Part);
	std::vector<std::string> ListNames(bool bFunctions, bool bTypes) const;
	std::string_view Keep(const std::string& Text);

	// HlslDeclarations.cpp
	const FType* FindType(const FTypeName& Name, uint32_t Modifiers);
	const FType* FindDeclaredType(const FDeclaration& Declaration, bool bParameter = false);
	const FType* AddDimensions(const FType* Type, const std::vector<FExpression*>& Dimensions, const FPlace& Place);
	const FType* FindNamedType(const FTypeName& Name, uint32_t Modifiers);
	const FType* FindBuiltInType(const FTypeName& Name, EOrder Order);
	const FType* FindObjectType(const FTypeName& Name, EObject Object);
	const FType* FindSymbolType(FSymbol& Symbol, const FNamePart& Part);
	const FType* CompleteAlias(FSymbol& Symbol);
	const FType* InstantiateAlias(FSymbol& Symbol, const FNamePart& Part);
	const FType* CompleteEnum(FSymbol& Symbol);
	FStructInfo* MakeStruct(const FStruct& Struct, FNameScope& Scope, const std::string& Name, uint32_t Order);
	const FType* CompleteStruct(FStructInfo& Info, const FPlace& Place);
	bool AddBits(const FDeclaration& Declaration, FStructInfo& Info, FStructType& Type, FSymbol* Field);
	void AddMembers(FStructInfo& Info, FStructType& Type);
	FVariable* FindGlobal(FSymbol& Symbol);
	void MakeGlobal(FSymbol& Symbol, FVariable& Variable);
	void SetConstant(FVariable& Variable);
	void MakeBuffer(const FDeclaration& Buffer, FNameScope& Scope);
	void AddLoose(FVariable& Variable, const FDeclaration& Declaration);
	void AddUnusedLoose();
	void ReadOffset(FVariable& Variable, const FDeclaration& Declaration);
	void CheckAssert(const FDeclaration& Declaration);
	std::optional<int64_t> FindInteger(const FExpression& Tree, const std::string& What);
	bool IsUsable(const FType* Type, const FPlace& Place);

	// HlslTemplates.cpp
	std::optional<FTemplateValue> ReadArgument(
		const FTemplateArgument& Argument, const FTemplateParameter& Parameter, FNameScope* TypeScope = nullptr);
	bool IsTypeArgument(const FTemplateArgument& Argument);
	void AddOutside(FSymbol& Symbol, FStructInfo& Info);
	void BindParameter(FNameScope& Scope, const FTemplateParameter& Parameter, const FTemplateValue& Value);
	bool Deduce(
		const FTypeName& Pattern, const std::vector<FExpression*>& Dimensions, const FType* Type, FDeduction& Into);
	bool DeducePart(const FNamePart& Part, const FType* Type, FDeduction& Into);
	bool DeduceArgument(const FTemplateArgument& Pattern, const FTemplateValue& Value, FDeduction& Into);
	bool DeduceValue(size_t Index, FTemplateValue Value, FDeduction& Into);
	bool FindArguments(FSymbol& Symbol, const FNamePart& Part, FNameScope& Scope, std::vector<FTemplateValue>& Values);
	FStructInfo* InstantiateStruct(FSymbol& Symbol, const FNamePart& Part);
	const FDeclaration* FindSpecialStruct(
		FSymbol& Symbol, const std::vector<FTemplateValue>& Values, FNameScope*& Scope);
	FOverload* InstantiateFunction(FSymbol& Symbol, FOverload& Overload, const FNamePart& Part,
		const std::vector<const FType*>& Arguments, std::string& Why);
	bool FillDefaults(FDeduction& Into, FNameScope& Scope, std::vector<FTemplateValue>& Values);
	const FDeclaration* FindSpecialFunction(
		FSymbol& Symbol, FOverload& Overload, const std::vector<FTemplateValue>& Values);
	bool CountInstance(const FPlace& Place);

	// HlslStatements.cpp: whether control can go on behind the statement
	bool AnalyseStatement(const FStatement& Statement, std::vector<FCode*>& Code);
	bool AnalyseBlock(const FStatement& Block, std::vector<FCode*>& Code, bool bScope = true);
	bool AnalyseScoped(const FStatement& Statement, FCode& Code);
	bool AnalyseIf(const FStatement& Statement, FCode& Code);
	void KeepLoopVariables(const FNameScope& Loop, FNameScope& Outer);
	bool AnalyseLoop(const FStatement& Statement, FCode& Code);
	bool AnalyseSwitch(const FStatement& Statement, FCode& Code);
	bool AnalyseCases(const FStatement& Body, const FType* Type, FCode& Code);
	void JoinCases(const std::vector<size_t>& Falls, const FPlace& Place, FCode& Code);
	void AddLabel(const FStatement& Label, const FType* Type, FCase& Case, std::set<uint32_t>& Seen);
	bool AnalyseJump(const FStatement& Statement, std::vector<FCode*>& Code);
	bool AnalyseReturn(const FStatement& Statement, FCode& Code);
	void AnalyseLocal(const FDeclaration& Declaration, std::vector<FCode*>& Code);
	void AnalyseLocalVariable(const FDeclaration& Declaration, std::vector<FCode*>& Code);
	FCode* MakeFirstTime(FVariable& Variable, FCode& First);
	void InitialiseLocal(const FDeclaration& Declaration, FVariable& Variable, std::vector<FCode*>& Code);
	void ReadAttributes(const FStatement& Statement, FCode& Code);
	bool IsRuntime(const FValue& Value) const;
	FCode* MakeCode(EStep Step, const FPlace& Place);

	// HlslExpressions.cpp
	FValue* Make(EValue Kind, const FType* Type, const FPlace& Place, std::vector<FValue*> Operands = {});
	FValue* MakeError(const FPlace& Place) { return Make(EValue::Zero, Types->Error(), Place); }
	FValue* MakeConstant(const FType* Type, FConstant Constant, const FPlace& Place);
	FValue* MakeVariable(FVariable& Variable, const FPlace& Place);
	FVariable* MakeTemporary(const FType* Type, const FPlace& Place);
	FValue* MakeOnce(FValue* Value, std::vector<FValue*>& Before);
	FValue* MakeCommas(std::vector<FValue*> Values);
	FValue* MakeSequence(std::vector<FValue*> Before, FValue* Value, const std::vector<FValue*>& After);
	FValue* Settle(FValue* Value);
	FValue* Simplify(FValue* Value);
	FValue* Convert(FValue* Value, const FType* To, bool bExplicit = false);
	FValue* SpreadConversion(FValue* Value, const FType* To);
	FValue* Analyse(const FExpression& Tree);
	FValue* AnalyseKind(const FExpression& Tree);
	FValue* AnalyseNumber(const FExpression& Tree);
	FValue* AnalyseName(const FExpression& Tree);
	FValue* MakeNamed(FSymbol& Symbol, FNameScope* Where, const FExpression& Tree);
	FValue* FailName(const FName& Name, const FPlace& Place);
	FValue* AnalyseThis(const FPlace& Place);
	FValue* AnalyseCast(const FExpression& Tree);
	FValue* AnalyseSizeOf(const FExpression& Tree);
	FValue* MakeCondition(FValue* Value, const std::string& What, const std::string& Advice);
	FValue* Uncast(FValue* Value);
	bool RequirePlace(FValue* Value, const std::string& What);
	void MarkWritten(FValue* Value);
	void MarkPrecise(FValue* Value);

	// HlslOperators.cpp
	FValue* AnalyseUnary(const FExpression& Tree);
	FValue* AnalyseStep(const FExpression& Tree, bool bPostfix);
	FValue* AnalyseBinary(const FExpression& Tree);
	FValue* MakeBinary(std::string_view Operator, FValue* Left, FValue* Right, const FPlace& Place);
	FValue* MakeShift(std::string_view Operator, FValue* Left, FValue* Right, const FPlace& Place);
	FValue* MakeLogical(const FExpression& Tree, FValue* Left, FValue* Right);
	FValue* AnalyseConditional(const FExpression& Tree);
	FValue* AnalyseAssign(const FExpression& Tree);
	FValue* AnalyseModify(const FExpression& Tree, FValue* Left, FValue* Right);
	FValue* ToPlain(FValue* Value);
	FValue* CallOperator(std::string_view Operator, FValue* Object, std::vector<FValue*> Others, const FPlace& Place);

	// HlslCalls.cpp
	FArguments AnalyseArguments(const FExpression& Tree, size_t First);
	FValue* AnalyseCall(const FExpression& Tree);
	FValue* CallName(const FExpression& Tree);
	FValue* CallSymbol(const FExpression& Tree, FSymbol& Symbol, FNameScope* Where, FArguments& Arguments);
	FValue* CallMember(const FExpression& Tree);
	FValue* CallMethod(const FExpression& Tree, FValue* Object, FSymbol& Symbol, FArguments& Arguments);
	void PrepareOverloads(FSymbol& Symbol);
	bool Sign(FOverload& Overload, bool bReport = true);
	std::vector<FOverload*> ListCandidates(FSymbol& Symbol, const FNamePart& Part,
		const std::vector<const FType*>& Arguments, std::vector<std::string>& Why);
	FOverload* ChooseOpened(FSymbol& Symbol, const FNamePart& Part, FArguments& Arguments, std::string& Why);
	FOverload* Choose(FSymbol& Symbol, const FNamePart& Part, const FArguments& Arguments, std::string& Why);
	FOverload* ChooseMoreSpecial(const std::vector<FOverload*>& Candidates, const std::vector<size_t>& Equal);
	FValue* MakeCall(FOverload& Overload, FValue* Object, const FArguments& Arguments, const FPlace& Place);
	FValue* MakeArgument(
		FOverload& Overload, size_t Index, FValue* Value, std::vector<FValue*>& Before, std::vector<FValue*>& After);
	FValue* MakeBaseArgument(
		const FParameterType& Parameter, FValue* Value, std::vector<FValue*>& Before, std::vector<FValue*>& After);
	bool IsDerived(const FType* Type, const FType* Base);
	void CopyMembers(FValue* To, FValue* From, const FType* Base, std::vector<FValue*>& Steps);
	FFunction* Require(FOverload& Overload, const FType* This);
	std::string Describe(const FOverload& Overload, std::string_view Name) const;

	// HlslBuiltInCalls.cpp: intrinsics, methods of resources, constructors
	FValue* CallIntrinsic(std::string_view Name, FArguments& Arguments, const FPlace& Place);
	FValue* CallResource(const FExpression& Tree, FValue* Object);
	FValue* FinishBuiltIn(EValue Kind, const FIntrinsicCall& Call, std::vector<FValue*> Values, FValue* Object,
		std::string_view Name, const FPlace& Place);
	FValue* SelectWhole(const std::vector<FValue*>& Values, const FPlace& Place);
	bool CheckStage(std::string_view Name, bool bMethod, const FPlace& Place);
	bool CheckOffset(const FIntrinsicCall& Call, const std::vector<FValue*>& Values, FValue* Object);
	FValue* MakeConstructor(const FType* Type, FArguments& Arguments, const FPlace& Place);

	// HlslAccess.cpp
	FValue* AnalyseMember(const FExpression& Tree);
	FValue* FindUniform(const FExpression& Tree);
	FValue* MakeMember(FValue* Object, const FName& Name, const FPlace& Place);
	FValue* MakeField(FValue* Object, FSymbol& Field, const FPlace& Place);
	FValue* MakeSwizzle(FValue* Object, std::string_view Text, const FPlace& Place);
	FValue* MakeElements(FValue* Object, std::string_view Text, const FPlace& Place);
	FValue* AnalyseIndex(const FExpression& Tree);
	FValue* MakeIndex(FValue* Object, FValue* Index, const FPlace& Place);
	FValue* MakeElement(FValue* Object, FValue* Index, const FPlace& Place);
	FValue* MakeMip(const FExpression& Tree, FValue* Object, FValue* Level, FValue* Index);
	FValue* OpenConstantBuffer(FValue* Object);
	FStructInfo* GetInfo(const FType* Type) const;

	// HlslInitializers.cpp
	FValue* Initialise(const FType* Type, const FExpression& Tree);
	void Collect(const FExpression& Tree, std::vector<FValue*>& Pieces);
	FValue* MakeFlat(const FType* Type, const std::vector<FValue*>& Pieces, const FPlace& Place);
	bool Spread(FValue* Piece, const std::vector<const FType*>& Leaves, size_t& At, std::vector<FValue*>& Parts,
		std::vector<FValue*>& Before);
	void ListLeaves(const FType* Type, std::vector<const FType*>& Leaves);

	// HlslEntry.cpp
	void AnalyseEntry();
	FOverload* FindEntry();
	void ReadEntryAttributes(const FDeclaration& Declaration);
	void ReadGroupSize(const FDeclaration& Declaration, const FAttribute& Attribute);
	void AddParameters(FFunction& Function, FOverload& Overload, bool bEntry);
	std::string ExplainStageValue(const std::string& Semantic, bool bOutput) const;
	void CheckStageValues(const FFunction& Function);
	void AddEntryParameter(FVariable& Variable, const FDeclaration& Declaration);
	void CheckSemantics(const FType* Type, const std::string& Name, const FPlace& Place);
	std::string FindSemantic(const std::vector<FAnnotation>& Annotations) const;

	struct FMessage
	{
		ESeverity Severity = ESeverity::Error;
		int Code = 6010;
		FPlace Place;
		std::string Text;
		std::vector<int> OtherLines;
	};
	struct FMade
	{
		uint32_t Order = 0;
		FVariable* Variable = nullptr;
	};

	const FTree& Tree;
	const FAnalysisOptions& Options;
	std::shared_ptr<FTypes> Types;
	std::shared_ptr<FProgram> Program;
	std::vector<FMessage> Messages;
	std::map<std::string, size_t> MessageByText;
	bool bFailed = false;

	std::deque<FNameScope> Scopes;
	std::deque<FOverload> Overloads;
	std::deque<FStructInfo> Structs;
	std::deque<std::string> Texts;
	std::map<std::pair<const FStruct*, FNameScope*>, FStructInfo*> StructsByTree;
	std::map<std::pair<const FEnum*, const FNameScope*>, FSymbol*> EnumsByTree;
	std::vector<std::pair<const FDeclaration*, FNameScope*>>
		Outside; // functions that are defined outside of their struct
	std::vector<std::pair<const FDeclaration*, FNameScope*>> Asserts;
	FNameScope* File = nullptr;
	uint32_t NumDeclarations = 0;
	int NumInstances = 0;
	int Depth = 0;
	int TypeDepth = 0;
	int TemplateDepth = 0;
	std::string Instance; // whose body is analysed, for messages

	FPosition Here;
	std::vector<std::pair<FFunction*, FOverload*>> Work; // bodies to be analysed
	std::map<const FFunction*, std::vector<std::pair<FFunction*, FPlace>>> Calls;
	std::vector<FMade> Statics;
	std::vector<FMade> Resources;
	std::vector<FMade> Loose;
	std::vector<std::pair<uint32_t, FBuffer*>> Buffers;
	std::map<const FVariable*, uint32_t> Offsets; // of packoffset
	std::vector<FVariable*> EntryUniforms;        // parameters of the entry
	FBuffer* Global = nullptr;

	friend class FPositionGuard;
};

/** Another position for a time. */
class FPositionGuard
{
public:
	FPositionGuard(FAnalyser& InAnalyser, FPosition Position)
		: Analyser(InAnalyser)
		, Saved(InAnalyser.Here)
	{
		Analyser.Here = Position;
	}
	~FPositionGuard() { Analyser.Here = Saved; }
	FPositionGuard(const FPositionGuard&) = delete;
	FPositionGuard& operator=(const FPositionGuard&) = delete;

private:
	FAnalyser& Analyser;
	FPosition Saved;
};

/** Counts a level for a time. */
class FLevel
{
public:
	explicit FLevel(int& InCount)
		: Count(InCount)
	{
		++Count;
	}
	~FLevel() { --Count; }
	FLevel(const FLevel&) = delete;
	FLevel& operator=(const FLevel&) = delete;

private:
	int& Count;
};

} // namespace Drydock::Hlsl
