// Looks at a module, and at the functions that its entry point calls.
#include "ShaderLint.h"

#include "EngineNames.h"
#include "HlslFrontEnd.h"
#include "HlslPartialStores.h"
#include "HlslTokens.h"
#include "LeftOutStages.h"
#include "LintAllowances.h"
#include "SpirvBarriers.h"
#include "LintLayout.h"
#include "ShaderFrontEnd.h"
#include "ShaderMessages.h"
#include "ShaderSource.h"
#include "SpirvFile.h"
#include "SpirvReflect.h"
#include "SpirvUniformity.h"

#include <algorithm>
#include <map>
#include <set>

namespace Drydock
{

namespace
{

using namespace Spirv;

class FLinter
{
public:
	FLinter(const FShaderCompileRequest& InRequest, uint8_t InPlatforms)
		: Request(InRequest)
		, Platforms(InPlatforms)
	{
	}

	std::vector<FLintFinding> Finish()
	{
		std::sort(Findings.begin(), Findings.end());
		Findings.erase(std::unique(Findings.begin(), Findings.end()), Findings.end());
		return std::move(Findings);
	}

	void LookAtText(const std::string& Source);
	/** Checks what any module shows, even one that drydock does not run. */
	void LookAtWords(const std::vector<uint32_t>& Words);
	void LookAtModule(const FSpirvModule& Module, const std::string& Source);

private:
	void Add(const char* Id, const std::string& File, int Line, const std::string& What)
	{
		const std::vector<FLintRule>& Rules = GetLintRules();
		const auto Rule = std::ranges::find(Rules, Id, &FLintRule::Id);
		if (Rule->Platforms & Platforms)
		{
			Findings.push_back({&*Rule, File.empty() ? Request.VirtualPath : File, Line, What});
		}
	}
	void AddAt(const char* Id, const FSpirvModule& Module, const FSpirvInstruction& I, const std::string& What)
	{
		Add(Id, Module.Files[I.File], I.Line, What);
	}
	/** Adds a finding at Where: "/Project/X.usf:9", or empty. */
	void AddWhere(const char* Id, const std::string& Where, const std::string& What)
	{
		const size_t Colon = Where.rfind(':');
		Add(Id, Where.substr(0, Colon), Colon == std::string::npos ? 0 : std::atoi(Where.c_str() + Colon + 1), What);
	}
	void LookAtInputs(const Hlsl::FProgram& Program);
	void LookAtInstruction(const FSpirvModule& Module, const FSpirvUniformity& Uniformity, const FSpirvBlock& Block,
		const FSpirvInstruction& I);
	/** Gives the finding of a type of 16 or 64 bits the place of its first instruction. */
	void PlaceWideType(const FSpirvModule& Module, const FSpirvInstruction& I);
	void LookAtGroup(uint32_t X, uint32_t Y, uint32_t Z);
	void LookAtResources(const FShaderReflection& Reflection);
	void LookAtLayout(const FSpirvModule& Module, const FShaderReflection& Reflection);

	const FShaderCompileRequest& Request;
	const uint8_t Platforms;
	std::vector<FLintFinding> Findings;
	std::set<std::pair<std::string, int>> PartialStores; // whose reads are drydock's own
	std::map<uint32_t, uint32_t> Images;                 // a loaded image -> its variable
	std::set<uint32_t> Stored;                           // variables of images that some instruction writes
};

/** Adds the inputs of a pixel shader, in the order of their registers. */
void AddInputs(const Hlsl::FType& Type, const std::string& Semantic, const Hlsl::FPlace& Place,
	std::vector<std::pair<std::string, Hlsl::FPlace>>& Inputs)
{
	if (!Type.IsStruct())
	{
		Inputs.emplace_back(Semantic, Place);
		return;
	}
	for (const Hlsl::FMember& Member : Type.Struct->Members)
	{
		AddInputs(*Member.Type, Member.Semantic, Member.Place, Inputs);
	}
}

/** Direct3D binds the outputs of a vertex shader to inputs by register. The engine's screen vertex shaders write
 * TEXCOORDs first and SV_Position behind them. */
void FLinter::LookAtInputs(const Hlsl::FProgram& Program)
{
	std::vector<std::pair<std::string, Hlsl::FPlace>> Inputs;
	for (const Hlsl::FVariable* Parameter : Program.Entry->Parameters)
	{
		const bool bInput = Parameter->Storage == Hlsl::EStorage::Parameter &&
							!(Parameter->Modifiers & (Hlsl::ModifierOut | Hlsl::ModifierUniform));
		if (bInput)
		{
			AddInputs(*Parameter->Type, Parameter->Semantic, Parameter->Place, Inputs);
		}
	}
	bool bPosition = false;
	for (const auto& [Semantic, Place] : Inputs)
	{
		bPosition = bPosition || Semantic.starts_with("SV_POSITION");
		if (bPosition && !Semantic.starts_with("SV_"))
		{
			Add("input-order", Program.Files[Place.File], Place.Line, Semantic + " behind SV_Position");
			return;
		}
	}
}

void FLinter::LookAtText(const std::string& Source)
{
	const FHlslText Text(Source, Request.VirtualPath);
	for (const FNotInEngine& Each : FindNotInEngine(Text, Request))
	{
		Add("not-in-engine", Each.File, Each.Line, Each.What);
	}
	if (Source.empty() || IsSpirvFile(Request.VirtualPath))
	{
		return;
	}
	const Hlsl::FAnalysis Read = Hlsl::Read(Source, Request);
	for (const Hlsl::FPlace& Place : Hlsl::ListPartialStores(*Read.Program))
	{
		const std::string& File = Read.Program->Files[Place.File];
		Add("partial-uav-store", File, Place.Line, "");
		PartialStores.insert({File, Place.Line});
	}
	if (Request.Stage == EShaderStage::Pixel)
	{
		LookAtInputs(*Read.Program);
	}
	for (const FDiagnostic& Warning : Read.Warnings)
	{
		const bool bOut = Warning.Message.starts_with("X3508");
		Add(bOut ? "out-not-set" : "compiler-warning", Warning.File, Warning.Line, Warning.Message);
	}
}

void FLinter::LookAtWords(const std::vector<uint32_t>& Words)
{
	static const std::map<uint32_t, const char*> Capabilities = {{9, "types-16"}, {10, "double"}, {11, "int64"},
		{12, "atomics-64"}, {22, "types-16"}, {4433, "types-16"}, {4434, "types-16"}};
	constexpr uint32_t LocalSize = 17;
	for (size_t At = HeaderWords; At < Words.size();)
	{
		const uint32_t Op = Words[At] & 0xFFFF;
		const size_t Size = std::max(1u, Words[At] >> 16);
		if (Op == OpCapability && At + 1 < Words.size() && Capabilities.count(Words[At + 1]))
		{
			Add(Capabilities.at(Words[At + 1]), {}, 0, "");
		}
		else if (Op == OpExecutionMode && At + 5 < Words.size() && Words[At + 2] == LocalSize)
		{
			LookAtGroup(Words[At + 3], Words[At + 4], Words[At + 5]);
		}
		At += Size;
	}
}

void FLinter::LookAtGroup(uint32_t X, uint32_t Y, uint32_t Z)
{
	const uint64_t Threads = uint64_t(X) * Y * Z;
	const std::string What = std::to_string(X) + " x " + std::to_string(Y) + " x " + std::to_string(Z) + " threads";
	if (Threads > 512)
	{
		Add("threads-512", {}, 0, What);
	}
}

void FLinter::LookAtInstruction(const FSpirvModule& Module, const FSpirvUniformity& Uniformity,
	const FSpirvBlock& Block, const FSpirvInstruction& I)
{
	constexpr uint32_t SinglePrecisionFormats[] = {3, 24, 33}; // R32f, R32i, R32ui
	const bool bPixel = Request.Stage == EShaderStage::Pixel;
	if (IsSpirvWave(I.Op))
	{
		AddAt("wave-operations", Module, I, "");
	}
	else if (I.Op == OpImageTexelPointer)
	{
		AddAt("atomics-texture", Module, I, "");
	}
	else if (I.Op == OpArrayLength)
	{
		AddAt("buffer-length", Module, I, "");
	}
	else if (I.Op == OpImageQuerySize && Module.GetValueType(I.Operands.at(0)).bStorageImage &&
			 Module.GetValueType(I.Operands.at(0)).Dim != DimBuffer)
	{
		AddAt("uav-size", Module, I, "");
	}
	else if (I.Op == OpImageRead)
	{
		const FSpirvType& Image = Module.GetValueType(I.Operands.at(0));
		const bool bSingle = std::find(std::begin(SinglePrecisionFormats), std::end(SinglePrecisionFormats),
								 Image.Format) != std::end(SinglePrecisionFormats);
		const bool bOwn = PartialStores.count({Module.Files[I.File], I.Line}) != 0;
		if (Image.bStorageImage && !bSingle && !bOwn)
		{
			AddAt("typed-uav-load", Module, I, "X3676 of FXC");
			AddAt("typed-uav-load-optional", Module, I, "");
			const auto Variable = Images.find(I.Operands.at(0));
			if (Image.Dim != DimBuffer && Variable != Images.end() && Stored.count(Variable->second) != 0)
			{
				AddAt("texture-read-write", Module, I, "");
			}
		}
	}
	else if (I.Op == OpImageQueryLevels)
	{
		AddAt("texture-levels", Module, I, "");
	}
	else if (bPixel &&
			 (I.Op == OpImageSampleImplicitLod || I.Op == OpImageSampleDrefImplicitLod ||
				 (I.Op >= OpDPdx && I.Op <= OpFwidthCoarse)) &&
			 Uniformity.IsDivergentBlock(Block.Label))
	{
		AddAt("derivative-divergent", Module, I, "");
	}
}

void FLinter::PlaceWideType(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	if (!I.Type || !I.Line || Module.GetType(I.Type).NumScalars == 0)
	{
		return;
	}
	const ESpirvType Kind = Module.GetScalarKind(I.Type, 0);
	const uint32_t Bytes = Kind == ESpirvType::Bool ? 4 : GetSpirvBytes(Kind);
	const std::string_view Id = Bytes == 2                   ? "types-16"
								: Kind == ESpirvType::Double ? "double"
								: Bytes == 8                 ? "int64"
															 : "";
	for (FLintFinding& Each : Findings) // one for each capability
	{
		if (Each.Line == 0 && Each.What.empty() && Id == Each.Rule->Id)
		{
			Each.File = Module.Files[I.File];
			Each.Line = I.Line;
		}
	}
}

void FLinter::LookAtResources(const FShaderReflection& Reflection)
{
	const auto Count = [this](const char* Id, const std::vector<FShaderResource>& A,
						   const std::vector<FShaderResource>& B, size_t Most, const char* Things)
	{
		const size_t Num = A.size() + B.size();
		if (Num > Most)
		{
			AddWhere(Id, (Most < A.size() ? A[Most] : B[Most - A.size()]).Where, std::to_string(Num) + " " + Things);
		}
	};
	Count("sampler-count", Reflection.Samplers, {}, 16, "samplers");
	std::vector<FShaderResource> RWBuffers;
	for (const FShaderResource& Buffer : Reflection.RWBuffers)
	{
		if (Buffer.CounterOf.empty())
		{
			RWBuffers.push_back(Buffer);
		}
		else
		{
			AddWhere("hidden-counter", Buffer.Where, Buffer.CounterOf);
		}
	}
	Count("uav-count", Reflection.RWTextures, RWBuffers, 8, "UAVs");
	Count("texture-count", Reflection.Textures, Reflection.RWTextures, 31, "textures");
	for (const FShaderConstantBuffer& Buffer : Reflection.ConstantBuffers)
	{
		if (Buffer.Size > 4096 * 16)
		{
			Add("constant-buffer-size", {}, 0, Buffer.Name + " has " + std::to_string(Buffer.Size) + " bytes");
		}
	}
	for (const auto* Buffers : {&Reflection.Buffers, &Reflection.RWBuffers})
	{
		for (const FShaderResource& Buffer : *Buffers)
		{
			if (Buffer.Dimension == EShaderDimension::StructuredBuffer && Buffer.Stride > 2048)
			{
				AddWhere("structure-stride", Buffer.Where,
					Buffer.Name + " has elements of " + std::to_string(Buffer.Stride) + " bytes");
			}
		}
	}
	if (Reflection.Stage == EShaderStage::Pixel && Reflection.NumTargets > 4)
	{
		Add("render-targets", {}, 0, std::to_string(Reflection.NumTargets) + " targets");
	}
}

void FLinter::LookAtLayout(const FSpirvModule& Module, const FShaderReflection& Reflection)
{
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvType& Type = Module.GetType(Variable.Type);
		if (!Type.bBufferBlock || Type.Members.empty())
		{
			continue;
		}
		const FSpirvType& Elements = Module.GetType(Type.Members[0].Type);
		FStd430 Element;
		const bool bAlike = Elements.Kind != ESpirvType::RuntimeArray ||
							(LiesAlike(Module, Elements.Element, Element) &&
								RoundUp(Element.Size, Element.Alignment) == Elements.ArrayStride);
		for (const auto* Buffers : {&Reflection.Buffers, &Reflection.RWBuffers})
		{
			for (const FShaderResource& Buffer : *Buffers)
			{
				if (!bAlike && Buffer.Name == Variable.Name && Buffer.Dimension == EShaderDimension::StructuredBuffer)
				{
					AddWhere("float3-layout", Buffer.Where,
						Buffer.Name + ": an element has " + std::to_string(Buffer.Stride) + " bytes in Direct3D, " +
							std::to_string(RoundUp(Element.Size, Element.Alignment)) + " by std430");
				}
			}
		}
	}
}

void FLinter::LookAtModule(const FSpirvModule& Module, const std::string& Source)
{
	const FSpirvStructure Structure = BuildSpirvStructure(Module);
	const FSpirvUniformity Uniformity = AnalyzeUniformity(Module, Structure);
	uint32_t SharedBytes = 0;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const uint32_t NumScalars = Module.GetType(Variable.Type).NumScalars;
		for (uint32_t i = 0; Variable.Storage == StorageWorkgroup && i < NumScalars; ++i)
		{
			SharedBytes += GetSpirvBytes(Module.GetScalarKind(Variable.Type, i));
		}
	}
	if (SharedBytes > 16352)
	{
		Add("groupshared-16k", {}, 0, std::to_string(SharedBytes) + " bytes");
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Op == OpLoad && Module.GetValueType(I.Result).Kind == ESpirvType::Image)
			{
				Images[I.Result] = I.Operands.at(0);
			}
			else if (I.Op == OpImageWrite)
			{
				Stored.insert(Images[I.Operands.at(0)]);
			}
		}
	}
	for (const FDivergentBarrier& Each : FindDivergentBarriers(Module, Structure, Uniformity))
	{
		AddAt("barrier-divergent", Module, *Each.Barrier,
			Each.Parting->Line ? "threads part in line " + std::to_string(Each.Parting->Line) : std::string());
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			LookAtInstruction(Module, Uniformity, Block, I);
			PlaceWideType(Module, I);
		}
	}
	const FShaderReflection Reflection = ReflectSpirv(Module, Structure, Source).Reflection;
	LookAtResources(Reflection);
	LookAtLayout(Module, Reflection);
}

} // namespace

std::vector<FLintFinding> LintSpirv(const std::vector<uint32_t>& Words, const std::string& Text,
	const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused)
{
	FLinter Linter(Request, Platforms);
	Linter.LookAtText(Text);
	Linter.LookAtWords(Words);
	try
	{
		Linter.LookAtModule(ReadSpirv(Words), Text);
	}
	catch (const FSpirvError& Error)
	{
		if (Refused)
		{
			Refused->push_back({ESeverity::Warning, 6020,
				std::string("not looked at beyond its text, for drydock does not run it: ") + Error.what(),
				Error.File.empty() ? Request.VirtualPath : Error.File, Error.Line, 0, {}});
		}
	}
	return Linter.Finish();
}

namespace
{

std::vector<FLintFinding> LintSource(const FShaderSource& Source, const FShaderCompileRequest& Request,
	uint8_t Platforms, std::vector<FDiagnostic>* Refused)
{
	std::vector<FLintFinding> Findings =
		LintSpirv(CompileToSpirv(Source, Request), Source.Text, Request, Platforms, Refused);
	FLintAllowances Allowances(Request);
	std::erase_if(Findings, [&Allowances](const FLintFinding& Finding)
		{ return Allowances.Allows(Finding.Rule->Id, Finding.File, Finding.Line); });
	return Findings;
}

} // namespace

std::vector<FLintFinding> LintShader(
	const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused)
{
	try
	{
		return LintSource(FlattenShader(Request), Request, Platforms, Refused);
	}
	catch (const FError& Error)
	{
		throw ExplainShaderErrors(Error, Request);
	}
}

std::vector<FLintFinding> FFileLinter::Lint(
	const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused)
{
	try
	{
		std::unique_ptr<FEntryTexts>& Texts = ByStage[Request.Stage];
		if (!Texts)
		{
			Texts = std::make_unique<FEntryTexts>(Request);
		}
		const FShaderSource Source = {
			.Text = Texts->GetText(Request.EntryPoint), .Files = {}, .Strings = {}, .Fingerprint = {}};
		if (!Source.Text.empty() && !FindLeftOutEntry(Source.Text, Request))
		{
			return LintSource(Source, Request, Platforms, Refused);
		}
	}
	catch (const FError&)
	{
		// The whole text has all messages.
	}
	return LintShader(Request, Platforms, Refused);
}

} // namespace Drydock
