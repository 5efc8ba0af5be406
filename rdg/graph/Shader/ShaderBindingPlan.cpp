// Matches a shader with a parameter struct by name and type. The messages name the shader class, the parameter, both
// types, the line of the .usf and of the C++ struct, and the nearest name.
#include "ShaderBindingPlan.h"

#include "UniformBufferStructs.h"
#include "VertexDraw.h"
#include "RangeTools.h"

#include <algorithm>
#include <set>

namespace Drydock
{

namespace
{

class FMatcher
{
public:
	FMatcher(const std::string& InShaderName, const FShaderReflection& InReflection,
		const FShaderParametersMetadata& InMetadata, std::vector<FDiagnostic>& InDiagnostics)
		: ShaderName(InShaderName)
		, Reflection(InReflection)
		, Metadata(InMetadata)
		, Diagnostics(InDiagnostics)
	{
		Plan.Sources.push_back({&Metadata, UBMT_INVALID, 0, "", true});
		for (const FHlslMember& Member : Metadata.GetHlslMembers())
		{
			if (Member.IsUniformBuffer())
			{
				Plan.Sources.push_back({Member.Struct, Member.BaseType, Member.Offset, Member.CodeName, false});
			}
		}
		const FShaderParametersMetadata* const OfFrame = GetFrameUniformBufferStruct();
		if (OfFrame && !HasUniformBuffer(OfFrame->GetShaderVariableName()))
		{
			Plan.Sources.push_back({OfFrame, UBMT_INVALID, 0, "", false, true});
		}
	}

	FShaderBindingPlan Match()
	{
		for (const FShaderConstant& Constant : Reflection.Constants)
		{
			if (Constant.bUsed)
			{
				MatchConstant(Constant);
			}
		}
		MatchResources(EResourceList::Textures, Reflection.Textures);
		MatchResources(EResourceList::RWTextures, Reflection.RWTextures);
		MatchResources(EResourceList::Samplers, Reflection.Samplers);
		MatchResources(EResourceList::Buffers, Reflection.Buffers);
		MatchResources(EResourceList::RWBuffers, Reflection.RWBuffers);
		ReportMissing();
		return std::move(Plan);
	}

private:
	/** A parameter that the shader reads and the struct lacks. */
	struct FMissing
	{
		EBindingError Code;
		std::string Name;
		std::string Type;
		std::string Where;
	};
	struct FFound
	{
		uint32_t Source = 0;
		const FHlslMember* Member = nullptr;
	};

	void Report(EBindingError Code, const std::string& Message, ESeverity Severity = ESeverity::Error)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Severity = Severity;
		Diagnostic.Code = Code;
		Diagnostic.Message = ShaderName + ": " + Message;
		Diagnostics.push_back(Diagnostic);
	}

	void ReportUnless(bool bTold, EBindingError Code, const std::string& Message)
	{
		if (!bTold)
		{
			Report(Code, Message);
		}
	}

	static bool HasName(const std::vector<FShaderResource>& Resources, const std::string& Name)
	{
		return std::any_of(Resources.begin(), Resources.end(),
			[&Name](const FShaderResource& Resource) { return Resource.Name == Name; });
	}

	std::string ReadBy(const std::string& Where) const
	{
		return "is read by " + (Where.empty() ? std::string("the shader") : Where);
	}

	/** The struct itself knows members by their flat name, a uniform buffer by `Buffer_Member`. */
	FFound Find(const std::string& HlslName, bool bConstant)
	{
		for (uint32_t Source = 0; Source < Plan.Sources.size(); ++Source)
		{
			const std::string Prefix =
				Source ? std::string(Plan.Sources[Source].Metadata->GetShaderVariableName()) + "_" : "";
			if (HlslName.compare(0, Prefix.size(), Prefix) != 0)
			{
				continue;
			}
			for (const FHlslMember& Member : Plan.Sources[Source].Metadata->GetHlslMembers())
			{
				if (Member.IsConstant() == bConstant && !Member.IsUniformBuffer() &&
					HlslName.compare(Prefix.size(), std::string::npos, Member.Name) == 0)
				{
					return {Source, &Member};
				}
			}
		}
		return {};
	}

	std::string Suggest(const std::string& HlslName) const
	{
		auto Names = ToVector<std::string>(Metadata.GetHlslMembers(), &FHlslMember::Name);
		const std::string Nearest = FindNearestName(HlslName, Names);
		return Nearest.empty() || Nearest == HlslName ? "" : "; did you mean '" + Nearest + "'?";
	}

	std::string DescribeCpp(const FHlslMember& Member) const
	{
		return "'" + Member.CodeName + "' (" + Member.DeclaredIn->GetFileName() + ":" +
			   std::to_string(Member.FileLine) + ")";
	}

	void MatchConstant(const FShaderConstant& Constant)
	{
		const std::string& BufferName = Reflection.ConstantBuffers[Constant.Buffer].Name;
		const bool bLoose = BufferName.empty() || BufferName[0] == '$';
		const FFound Found = Find(Constant.Name, true);
		if (!Found.Member)
		{
			ReportMissingConstant(Constant, bLoose ? "" : BufferName);
			return;
		}
		const FHlslMember& Member = *Found.Member;
		const bool bWide = GetBits(Constant.Scalar) != 32;
		const bool bFloat = Constant.Scalar == EShaderScalar::Float;
		if (bWide || bFloat != (Member.BaseType == UBMT_FLOAT32) ||
			Constant.Rows != static_cast<int32_t>(Member.NumRows) ||
			Constant.Columns != static_cast<int32_t>(Member.NumColumns) ||
			(Constant.NumElements > 0) != (Member.NumElements > 0))
		{
			Report(ParameterType, "'" + Constant.Name + "' is " + GetTypeName(Constant) + " where it " +
									  ReadBy(Constant.Where) + ", but " +
									  WithElements(Member.Type, Member.NumElements) + " in " +
									  Found.Member->DeclaredIn->GetStructTypeName() + ": " + DescribeCpp(Member) +
									  (bWide ? "; parameters have 32 bits" : ""));
			return;
		}
		if (Constant.NumElements > static_cast<int32_t>(Member.NumElements))
		{
			Report(ParameterArray, "'" + Constant.Name + "' has " + std::to_string(Constant.NumElements) +
									   " elements where it " + ReadBy(Constant.Where) + ", but only " +
									   std::to_string(Member.NumElements) + " in " +
									   Found.Member->DeclaredIn->GetStructTypeName() + ": " + DescribeCpp(Member));
			return;
		}
		Use(Found.Source, Constant.Name, Constant.Where);
		AddCopies(Constant, Member, Found.Source);
	}

	void ReportMissingConstant(const FShaderConstant& Constant, const std::string& UniformBuffer)
	{
		if (!UniformBuffer.empty() && !HasUniformBuffer(UniformBuffer))
		{
			ReportMissingUniformBuffer(UniformBuffer, Constant.Name, Constant.Where);
			return;
		}
		Missing.push_back({MissingParameter, Constant.Name, GetTypeName(Constant), Constant.Where});
	}

	/** "Input" of "Input_Extent"; empty where there is no such part. */
	static std::string GetPrefix(const std::string& HlslName)
	{
		const size_t Line = HlslName.find('_');
		return Line == std::string::npos ? std::string() : HlslName.substr(0, Line);
	}

	/** A message for each; one for all members of a struct that is missing as a whole. */
	void ReportMissing()
	{
		std::set<std::string> Prefixes;
		for (const FHlslMember& Member : Metadata.GetHlslMembers())
		{
			Prefixes.insert(GetPrefix(Member.Name));
		}
		const std::string Struct = Metadata.GetStructTypeName();
		std::set<std::string> Reported;
		for (const FMissing& Each : Missing)
		{
			const std::string Prefix = GetPrefix(Each.Name);
			const auto NumOthers = std::count_if(Missing.begin(), Missing.end(),
									   [&Prefix](const FMissing& Other) { return GetPrefix(Other.Name) == Prefix; }) -
								   1;
			const std::string Name = "'" + Each.Name + "' (" + Each.Type + ") ";
			if (Prefix.empty() || Prefixes.count(Prefix) || NumOthers == 0)
			{
				Report(Each.Code,
					Name + ReadBy(Each.Where) + " but " + Struct + " has no such member" + Suggest(Each.Name));
			}
			else if (Reported.insert(Prefix).second)
			{
				const std::string Nearest =
					FindNearestName(Prefix, std::vector<std::string>(Prefixes.begin(), Prefixes.end()));
				Report(Each.Code, Name + ReadBy(Each.Where) + ", and " + std::to_string(NumOthers) +
									  (NumOthers == 1 ? " other '" : " others '") + Prefix + "_...', but " + Struct +
									  " has none of them, and no SHADER_PARAMETER_STRUCT '" + Prefix + "'" +
									  (Nearest.empty() ? std::string() : "; did you mean '" + Nearest + "'?"));
			}
		}
	}

	bool HasUniformBuffer(const std::string& HlslName) const
	{
		return std::any_of(Plan.Sources.begin(), Plan.Sources.end(),
			[&HlslName](const FBindingSource& Source)
			{
				const TCHAR* const Name = Source.Metadata->GetShaderVariableName();
				return Source.BaseType != UBMT_INVALID && Name && HlslName == Name;
			});
	}

	/** "; it has those of View, SceneTexturesStruct". */
	std::string ListUniformBuffers() const
	{
		std::string List;
		for (const FBindingSource& Source : Plan.Sources)
		{
			const TCHAR* const Name = Source.Metadata->GetShaderVariableName();
			const bool bBuffer = Source.BaseType != UBMT_INVALID && Name;
			List += bBuffer ? (List.empty() ? "; it has those of " : ", ") + std::string(Name) : std::string();
		}
		return List;
	}

	/** The registered uniform buffer that a resource of this name belongs to; empty when none. */
	static std::string FindUniformBufferOf(const std::string& HlslName)
	{
		for (const FShaderParametersMetadata* Struct : GetUniformBufferStructs())
		{
			const std::string Prefix = std::string(Struct->GetShaderVariableName()) + "_";
			for (const FHlslMember& Member : Struct->GetHlslMembers())
			{
				if (HlslName == Prefix + Member.Name)
				{
					return Struct->GetShaderVariableName();
				}
			}
		}
		return {};
	}

	void Use(uint32_t Source, const std::string& HlslName, const std::string& Where)
	{
		Plan.Sources[Source].bUsed = true;
		if (Plan.Sources[Source].bOfFrame)
		{
			ReportMissingUniformBuffer(Plan.Sources[Source].Metadata->GetShaderVariableName(), HlslName, Where, true);
		}
	}

	/** Once for a buffer, however many of its members are read. */
	void ReportMissingUniformBuffer(
		const std::string& UniformBuffer, const std::string& HlslName, const std::string& Where, bool bOfFrame = false)
	{
		if (!MissingBuffers.insert(UniformBuffer).second || IsBoundByDraw(Reflection, UniformBuffer))
		{
			return;
		}
		const FShaderParametersMetadata* const Struct = FindUniformBufferStruct(UniformBuffer);
		const std::string Arguments =
			Struct ? std::string("(") + Struct->GetStructTypeName() + ", " + UniformBuffer + ")" : std::string();
		Report(MissingUniformBuffer,
			"'" + HlslName + "' of uniform buffer '" + UniformBuffer + "' " + ReadBy(Where) + ", but " +
				Metadata.GetStructTypeName() + " has no SHADER_PARAMETER_STRUCT_REF" + Arguments +
				" or SHADER_PARAMETER_RDG_UNIFORM_BUFFER of that buffer" + ListUniformBuffers() +
				(bOfFrame
						? "; the shader reads the frame's own. The engine reports it too, and 5.2 and before end there"
						: ""),
			bOfFrame ? ESeverity::Warning : ESeverity::Error);
	}

	/** Elements are 16 bytes apart in C++; matrices are row after row there, and in HLSL as the reflection says. */
	void AddCopies(const FShaderConstant& Constant, const FHlslMember& Member, uint32_t Source)
	{
		constexpr uint32_t ScalarSize = 4;
		const uint32_t Rows = Member.NumRows;
		const uint32_t Columns = Member.NumColumns;
		const uint32_t ElementSize = (Rows * Columns * ScalarSize + 15) / 16 * 16;
		for (uint32_t Element = 0; Element < std::max(1u, static_cast<uint32_t>(Constant.NumElements)); ++Element)
		{
			const uint32_t From = Member.Offset + Element * ElementSize;
			const uint32_t To = Constant.Offset + Element * Constant.ArrayStride;
			if (Rows == 1)
			{
				Plan.Constants.push_back({Source, From, Constant.Buffer, To, Columns * ScalarSize});
				continue;
			}
			for (uint32_t Row = 0; Row < Rows; ++Row)
			{
				for (uint32_t Column = 0; Column < Columns; ++Column)
				{
					const uint32_t Target = Constant.bRowMajor ? Row * Constant.MatrixStride + Column * ScalarSize
															   : Column * Constant.MatrixStride + Row * ScalarSize;
					Plan.Constants.push_back({Source, From + (Row * Columns + Column) * ScalarSize, Constant.Buffer,
						To + Target, ScalarSize});
				}
			}
		}
	}

	void MatchResources(EResourceList List, const std::vector<FShaderResource>& Resources)
	{
		for (uint32_t Slot = 0; Slot < Resources.size(); ++Slot)
		{
			const FShaderResource& Resource = Resources[Slot];
			const std::string HlslType = GetTypeName(List, Resource);
			// A hidden counter comes with the view of its buffer.
			const std::string& Name = Resource.CounterOf.empty() ? Resource.Name : Resource.CounterOf;
			const FFound Found = Find(Name, false);
			const bool bTold = !Resource.CounterOf.empty() && HasName(Resources, Name); // what is wrong with the buffer
			FRHISamplerState* const StaticSampler =
				List == EResourceList::Samplers && !Found.Member ? FindStaticSampler(Resource.Name) : nullptr;
			if (StaticSampler)
			{
				Plan.StaticSamplers.push_back({Slot, StaticSampler});
				continue;
			}
			const std::string UniformBuffer = Found.Member ? std::string() : FindUniformBufferOf(Name);
			if (!UniformBuffer.empty() && !HasUniformBuffer(UniformBuffer))
			{
				ReportMissingUniformBuffer(UniformBuffer, Name, Resource.Where);
				continue;
			}
			if (!Found.Member)
			{
				if (!bTold)
				{
					Missing.push_back({MissingResource, Name, HlslType, Resource.Where});
				}
				continue;
			}
			const FHlslMember& Member = *Found.Member;
			if (!Accepts(List, Member.BaseType) ||
				(List != EResourceList::Samplers && !TypeTextAgrees(Member.Type, HlslType)))
			{
				ReportUnless(bTold, ResourceType,
					"'" + Name + "' is " + HlslType + " where it " + ReadBy(Resource.Where) + ", but " + Member.Type +
						" (" + GetBaseTypeName(Member.BaseType) + ") in " + Member.DeclaredIn->GetStructTypeName() +
						": " + DescribeCpp(Member));
				continue;
			}
			const int Bits = GetElementBits(Member.Type);
			if (Resource.Dimension == EShaderDimension::StructuredBuffer && Bits != 0 &&
				Bits != GetBits(Resource.Scalar))
			{
				Report(ResourceType, "'" + Resource.Name + "' has elements of " + GetScalarName(Resource.Scalar) +
										 ", of " + std::to_string(GetBits(Resource.Scalar)) + " bits, where it " +
										 ReadBy(Resource.Where) + ", but is " + Member.Type + " in " +
										 Member.DeclaredIn->GetStructTypeName() + ": " + DescribeCpp(Member));
				continue;
			}
			Use(Found.Source, Name, Resource.Where);
			const std::string Prefix = Found.Source ? Plan.Sources[Found.Source].CodeName + "." : "";
			Plan.Resources.push_back(
				{List, Slot, Found.Source, Member.Offset, Member.BaseType, Prefix + Member.CodeName});
		}
	}

	const std::string& ShaderName;
	const FShaderReflection& Reflection;
	const FShaderParametersMetadata& Metadata;
	std::vector<FDiagnostic>& Diagnostics;
	FShaderBindingPlan Plan;
	std::set<std::string> MissingBuffers; // reported
	std::vector<FMissing> Missing;        // members of the struct
};

} // namespace

bool IsBoundByDraw(const FShaderReflection& Reflection, const std::string& UniformBuffer)
{
	return Reflection.Stage == EShaderStage::Vertex && UniformBuffer == GDrawRectangleParametersName;
}

FShaderBindingPlan MakeShaderBindingPlan(const std::string& ShaderName, const FShaderReflection& Reflection,
	const FShaderParametersMetadata& Metadata, std::vector<FDiagnostic>& Diagnostics)
{
	return FMatcher(ShaderName, Reflection, Metadata, Diagnostics).Match();
}

} // namespace Drydock
