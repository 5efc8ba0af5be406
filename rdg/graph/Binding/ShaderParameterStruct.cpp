// Drops from a parameter struct the graph resources that no shader of the pass reads, and checks that the others are
// set.
#include "ShaderParameterStruct.h"

#include "BoundContents.h"
#include "RenderGraphReport.h"
#include "RenderGraphResources.h"
#include "ShaderCompilation.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

bool IsGraphResource(EUniformBufferBaseType BaseType)
{
	switch (BaseType)
	{
	case UBMT_RDG_TEXTURE:
	case UBMT_RDG_TEXTURE_SRV:
	case UBMT_RDG_TEXTURE_UAV:
	case UBMT_RDG_BUFFER_SRV:
	case UBMT_RDG_BUFFER_UAV:
	case UBMT_RDG_UNIFORM_BUFFER:
		return true;
	default:
		return false;
	}
}

/** The names under which a shader reads resources, and the uniform buffers from which it reads anything. */
bool Reads(const FShaderReflection& Reflection, const FHlslMember& Member)
{
	const std::string Prefix =
		Member.IsUniformBuffer() ? std::string(Member.Struct->GetShaderVariableName()) + "_" : "";
	const auto IsMeant = [&Member, &Prefix](const std::string& Name)
	{
		return Prefix.empty() ? Name == Member.Name : Name.compare(0, Prefix.size(), Prefix) == 0;
	};
	const auto IsAnyMeant = [&IsMeant](const std::vector<FShaderResource>& Resources)
	{
		return std::ranges::any_of(
			Resources, [&IsMeant](const FShaderResource& Resource) { return IsMeant(Resource.Name); });
	};
	const auto IsConstantMeant = [&IsMeant](const FShaderConstant& Constant)
	{
		return Constant.bUsed && IsMeant(Constant.Name);
	};
	return IsAnyMeant(Reflection.Textures) || IsAnyMeant(Reflection.RWTextures) || IsAnyMeant(Reflection.Samplers) ||
		   IsAnyMeant(Reflection.Buffers) || IsAnyMeant(Reflection.RWBuffers) ||
		   std::ranges::any_of(Reflection.Constants, IsConstantMeant);
}

std::shared_ptr<const FShaderReflection> GetReflectionIfAny(const FShaderRef& Shader)
{
	return Shader.IsValid() && IsRun(Shader) ? GetShaderReflection(Shader) : nullptr;
}

void ClearUnused(const std::vector<std::shared_ptr<const FShaderReflection>>& Reflections,
	const FShaderParametersMetadata& Metadata, void* Parameters, std::initializer_list<FRDGResource*> ExcludeList)
{
	if (!Parameters)
	{
		ThrowRDGError(RDGErrorNullArgument, "the shader parameters are null",
			std::string("ClearUnusedGraphResources, struct ") + Metadata.GetStructTypeName());
	}
	for (const FHlslMember& Member : Metadata.GetHlslMembers())
	{
		void* const Resource =
			IsGraphResource(Member.BaseType) ? ReadPointer<void>(Parameters, Member.Offset) : nullptr;
		const auto ReadsMember = [&Member](const std::shared_ptr<const FShaderReflection>& Reflection)
		{
			return Reflection && Reads(*Reflection, Member);
		};
		const auto IsResource = [Resource](const FRDGResource* Kept)
		{
			return static_cast<const void*>(Kept) == Resource;
		};
		if (Resource && std::ranges::none_of(Reflections, ReadsMember) && std::ranges::none_of(ExcludeList, IsResource))
		{
			std::memset(static_cast<uint8*>(Parameters) + Member.Offset, 0, sizeof(void*));
		}
	}
}

} // namespace

} // namespace Drydock

void ValidateShaderParameters(
	const TShaderRef<FShader>& Shader, const FShaderParametersMetadata* ParametersMetadata, const void* Parameters)
{
	Drydock::RequireShaderParameters(Shader, *ParametersMetadata, Parameters);
}

void ClearUnusedGraphResources(const TShaderRef<FShader>& Shader, const FShaderParametersMetadata* ParametersMetadata,
	void* InoutParameters, std::initializer_list<FRDGResource*> ExcludeList)
{
	Drydock::ClearUnused({Drydock::GetReflectionIfAny(Shader)}, *ParametersMetadata, InoutParameters, ExcludeList);
}

void ClearUnusedGraphResources(const TShaderRef<FShader>& ShaderA, const TShaderRef<FShader>& ShaderB,
	const FShaderParametersMetadata* ParametersMetadata, void* InoutParameters,
	std::initializer_list<FRDGResource*> ExcludeList)
{
	Drydock::ClearUnused({Drydock::GetReflectionIfAny(ShaderA), Drydock::GetReflectionIfAny(ShaderB)},
		*ParametersMetadata, InoutParameters, ExcludeList);
}
