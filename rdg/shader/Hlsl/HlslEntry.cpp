// The entry: which function it is, its parameters and semantics, the attributes before it.
#include "HlslAnalysisImpl.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr int64_t MaxGroupThreads = 1024;

const std::vector<std::string> EntryComputeInputs = {
	"SV_DispatchThreadID", "SV_GroupID", "SV_GroupThreadID", "SV_GroupIndex"};

const std::vector<std::string> EntrySystemValues = {"SV_Position", "SV_Target", "SV_Depth", "SV_DepthGreaterEqual",
	"SV_DepthLessEqual", "SV_StencilRef", "SV_Coverage", "SV_InnerCoverage", "SV_IsFrontFace", "SV_SampleIndex",
	"SV_PrimitiveID", "SV_VertexID", "SV_InstanceID", "SV_StartVertexLocation", "SV_StartInstanceLocation",
	"SV_ClipDistance", "SV_CullDistance", "SV_RenderTargetArrayIndex", "SV_ViewportArrayIndex", "SV_ViewID",
	"SV_Barycentrics", "SV_ShadingRate", "SV_DispatchThreadID", "SV_GroupID", "SV_GroupThreadID", "SV_GroupIndex"};

bool HasEntryValue(const std::vector<std::string>& Values, const std::string& Semantic)
{
	const std::string Name = Semantic.substr(0, Semantic.find_last_not_of("0123456789") + 1);
	return std::ranges::any_of(
		Values, [Name = ToLowerCase(Name)](const std::string& Each) { return ToLowerCase(Each) == Name; });
}

} // namespace

FOverload* FAnalyser::FindEntry()
{
	const auto Found = File->Symbols.find(Options.EntryPoint);
	FOverload* Best = nullptr;
	const auto HasThreads = [](const FOverload& Overload)
	{
		return std::ranges::any_of(
			Overload.Declaration->Attributes, [](const FAttribute& Each) { return Each.Name == "numthreads"; });
	};
	if (Found != File->Symbols.end() && Found->second.Kind == ESymbol::Functions)
	{
		for (FOverload* Overload : Found->second.Overloads)
		{
			const bool bBody = Overload->Declaration->Body && !Overload->Declaration->bTemplate;
			if (bBody && (!Best || Options.Stage != EStage::Compute || HasThreads(*Overload) || !HasThreads(*Best)))
			{
				Best = Overload;
			}
		}
	}
	if (!Best)
	{
		Here.Order = NumDeclarations;
		std::vector<std::string> Known;
		for (const auto& [Name, Symbol] : File->Symbols)
		{
			const bool bEntry = std::ranges::any_of(Symbol.Overloads,
				[&](const FOverload* Each)
				{
					const FDeclaration& Declared = *Each->Declaration;
					const bool bSemantics = !Declared.Annotations.empty() ||
											std::ranges::any_of(Declared.Parameters, [](const FDeclaration* Parameter)
												{ return !Parameter->Annotations.empty(); });
					return Declared.Body != nullptr && (HasThreads(*Each) || bSemantics);
				});
			if (Symbol.Kind == ESymbol::Functions && bEntry)
			{
				Known.emplace_back(Name);
			}
		}
		std::ranges::sort(Known);
		const std::string Suggestion = SuggestName(Options.EntryPoint, Known);
		Error(FPlace(),
			"entry point '" + Options.EntryPoint + "' does not exist in this shader" +
				(Suggestion.empty() && !Known.empty() ? "; it has " + JoinText(Known) : Suggestion),
			6011);
	}
	return Best;
}

void FAnalyser::AnalyseEntry()
{
	FOverload* const Overload = FindEntry();
	if (!Overload)
	{
		return;
	}
	PrepareOverloads(File->Symbols.find(Options.EntryPoint)->second);
	const FDeclaration& Declaration = *Overload->Declaration;
	FPosition Position;
	Position.Scope = File;
	Position.Order = Overload->BodyOrder;
	const FPositionGuard Guard(*this, Position);
	ReadEntryAttributes(Declaration);
	if (!Sign(*Overload))
	{
		return;
	}
	FFunction* const Function = Program->Make<FFunction>();
	Function->Name = Options.EntryPoint;
	Function->Place = Declaration.Place;
	Function->Result = Overload->Result;
	Function->Semantic = FindSemantic(Declaration.Annotations);
	Program->Entry = Function;
	Overload->Made[nullptr] = Function;
	AddParameters(*Function, *Overload, true);
	if (Function->Result->Kind != EType::Void && Function->Semantic.empty())
	{
		CheckSemantics(Function->Result, "what '" + Function->Name + "' returns", Declaration.Place);
	}
	CheckStageValues(*Function);
	Work.emplace_back(Function, Overload);
}

/** Why an entry of the stage cannot have the semantic; empty where it can. */
std::string FAnalyser::ExplainStageValue(const std::string& Semantic, bool bOutput) const
{
	const bool bSystem = Semantic.starts_with("SV_");
	if (Semantic.empty())
	{
		return {};
	}
	if (bSystem && !HasEntryValue(EntrySystemValues, Semantic))
	{
		const std::string Name = Semantic.substr(0, Semantic.find_last_not_of("0123456789") + 1);
		return "X4502: '" + Name + "' is not a system value" + SuggestName(Name, EntrySystemValues);
	}
	if (Options.Stage == EStage::Compute && bOutput)
	{
		return "a compute shader has no outputs, and '" + Semantic + "' is one: write into a UAV";
	}
	if (Options.Stage == EStage::Compute && (!HasEntryValue(EntryComputeInputs, Semantic) || Semantic.back() != '0'))
	{
		return "X4502: a compute shader has no input '" + Semantic +
			   "'; it has SV_DispatchThreadID, SV_GroupID, SV_GroupThreadID and SV_GroupIndex";
	}
	if (Semantic.starts_with("SV_TARGET") && (Semantic.size() != 10 || Semantic.back() > '7'))
	{
		return "X4571: '" + Semantic + "': a pixel shader has the targets SV_Target0 to SV_Target7";
	}
	return {};
}

/** A semantic stands once among the inputs and once among the outputs. */
void FAnalyser::CheckStageValues(const FFunction& Function)
{
	std::set<std::string> Seen[2];
	std::vector<std::string> Names;
	bool bOutputs = false;
	const auto AddNames = [&](auto&& Self, const FType* Type, const std::string& Semantic) -> void
	{
		if (Type->IsStruct() && Semantic.empty())
		{
			for (const FMember& Member : Type->Struct->Members)
			{
				Self(Self, Member.Type, bOutputs ? Program->MapOutput(Member.Semantic) : Member.Semantic);
			}
			return;
		}
		Names.push_back(Semantic);
	};
	const auto AddAll = [&](const FType* Type, const std::string& Semantic, const FPlace& Place, bool bOutput)
	{
		Names.clear();
		bOutputs = bOutput;
		AddNames(AddNames, Type, bOutput ? Program->MapOutput(Semantic) : Semantic);
		for (const std::string& Name : Names)
		{
			const std::string Problem = ExplainStageValue(Name, bOutput);
			if (!Problem.empty())
			{
				Error(Place, Problem);
			}
			else if (!Name.empty() && !Seen[bOutput].insert(Name).second)
			{
				Error(Place, "X3000: the semantic '" + Name + "' stands twice among the " +
								 (bOutput ? "outputs" : "inputs") + " of the entry; give each an index of its own");
			}
		}
	};
	for (const FVariable* Parameter : Function.Parameters)
	{
		for (const bool bOutput : {false, true})
		{
			if (Parameter->Modifiers & (bOutput ? ModifierOut : ModifierIn))
			{
				AddAll(Parameter->Type, Parameter->Semantic, Parameter->Place, bOutput);
			}
		}
	}
	AddAll(Function.Result, Function.Semantic, Function.Place, true);
}

void FAnalyser::AddParameters(FFunction& Function, FOverload& Overload, bool bEntry)
{
	for (size_t i = 0; i < Overload.Parameters.size(); ++i)
	{
		const FDeclaration& Declaration = *Overload.Declared[i];
		const FParameterType& Parameter = Overload.Parameters[i];
		FVariable& Variable = *Program->Make<FVariable>();
		Variable.Name = std::string(Declaration.Name.Last());
		Variable.Type = Parameter.Type;
		Variable.Place = Declaration.Place;
		Variable.Modifiers = Declaration.Modifiers | Declaration.Type->Modifiers | (Parameter.bIn ? ModifierIn : 0u);
		Variable.ResourceName = Variable.Name;
		Variable.Storage = EStorage::Parameter;
		const bool bGlobal = bEntry && (Declaration.Modifiers & ModifierUniform || HasObject(Parameter.Type));
		if (bGlobal)
		{
			AddEntryParameter(Variable, Declaration);
			continue;
		}
		Variable.Index = uint32_t(Function.Parameters.size());
		Function.Parameters.push_back(&Variable);
		if (bEntry)
		{
			Variable.Semantic = FindSemantic(Declaration.Annotations);
			if (Variable.Semantic.empty())
			{
				CheckSemantics(Variable.Type, "'" + Variable.Name + "'", Variable.Place);
			}
		}
	}
}

/** A uniform parameter is one of the shader's. */
void FAnalyser::AddEntryParameter(FVariable& Variable, const FDeclaration& Declaration)
{
	const FMade Made{Here.Order, &Variable};
	EntryUniforms.push_back(&Variable);
	if (HasObject(Variable.Type))
	{
		Variable.Storage = EStorage::Resource;
		Resources.push_back(Made);
		return;
	}
	AddLoose(Variable, Declaration);
	Loose.push_back(Made);
}

void FAnalyser::CheckSemantics(const FType* Type, const std::string& Name, const FPlace& Place)
{
	while (Type->IsArray())
	{
		Type = Type->Element;
	}
	if (!Type->IsStruct())
	{
		Error(Place, "X3502: " + Name +
						 " of the entry is missing its semantic; write : TEXCOORD0, : SV_Position, : SV_Target0 or the "
						 "like behind it");
		return;
	}
	for (const FMember& Member : Type->Struct->Members)
	{
		if (Member.Semantic.empty())
		{
			CheckSemantics(Member.Type, "the member '" + Member.Name + "' of '" + GetName(Type) + "'", Member.Place);
		}
	}
}

/** In capital letters, with an index. */
std::string FAnalyser::FindSemantic(const std::vector<FAnnotation>& Annotations) const
{
	for (const FAnnotation& Annotation : Annotations)
	{
		if (Annotation.Name == "register" || Annotation.Name == "packoffset" || Annotation.Name.empty())
		{
			continue;
		}
		std::string Name(Annotation.Name);
		std::ranges::transform(
			Name, Name.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
		const bool bIndex = Name.back() >= '0' && Name.back() <= '9';
		return bIndex ? Name : Name + "0";
	}
	return {};
}

void FAnalyser::ReadEntryAttributes(const FDeclaration& Declaration)
{
	bool bGroup = false;
	for (const FAttribute& Attribute : Declaration.Attributes)
	{
		if (Attribute.Name == "numthreads" && Options.Stage == EStage::Compute)
		{
			bGroup = true;
			ReadGroupSize(Declaration, Attribute);
		}
		else if (Attribute.Name == "wavesize" && !Attribute.Arguments.empty())
		{
			const std::optional<int64_t> Size = FindInteger(*Attribute.Arguments[0], "the number of [WaveSize]");
			if (Size && (*Size < 4 || *Size > 128 || (*Size & (*Size - 1)) != 0))
			{
				Error(Attribute.Place, "[WaveSize(N)] takes 4, 8, 16, 32, 64 or 128, not " + std::to_string(*Size));
			}
			Program->WaveSize = Size ? uint32_t(*Size) : 0;
		}
		else if (Attribute.Name == "earlydepthstencil")
		{
			Program->bEarlyDepthStencil = true;
		}
	}
	if (Options.Stage == EStage::Compute && !bGroup)
	{
		Error(Declaration.Place,
			"the compute shader '" + Options.EntryPoint + "' has no [numthreads(X, Y, Z)] before it: its group's size");
	}
}

void FAnalyser::ReadGroupSize(const FDeclaration& Declaration, const FAttribute& Attribute)
{
	(void)Declaration;
	const std::string Of = "[numthreads] of '" + Options.EntryPoint + "'";
	if (Attribute.Arguments.size() != 3)
	{
		Error(Attribute.Place,
			Of + " has " + std::to_string(Attribute.Arguments.size()) + " numbers; wanted are three from 1 on");
		return;
	}
	int64_t Threads = 1;
	for (size_t i = 0; i < 3; ++i)
	{
		const std::optional<int64_t> Size = FindInteger(*Attribute.Arguments[i], "a number of [numthreads]");
		if (!Size)
		{
			return;
		}
		if (*Size < 1)
		{
			Error(Attribute.Arguments[i]->Place, Of + (*Size < 0 ? " has a negative number; wanted are three from 1 on"
																 : " has a 0; wanted are three from 1 on"));
			return;
		}
		const int64_t Most = i == 2 ? 64 : MaxGroupThreads;
		Threads *= std::min(*Size, MaxGroupThreads + 1);
		if (*Size > Most || Threads > MaxGroupThreads)
		{
			Error(Attribute.Arguments[i]->Place,
				"X3663: " + Of + " has too many threads: a group has at most 1024, and at most 64 in z");
			return;
		}
		Program->GroupSize[i] = uint32_t(*Size);
	}
}

} // namespace Drydock::Hlsl
