// Feeds a vertex shader from the buffers that the vertex declaration names. Source of the formats and of what happens
// beyond a buffer's end (0): Direct3D 11, "Input-Assembler stage".
#include "VertexDraw.h"

#include "PixelFormatConversion.h"
#include "RunningCode.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <map>

namespace Drydock
{

namespace
{

std::atomic<FShaderBinder> GBinder{nullptr};

[[noreturn]] void ThrowInput(const std::string& Message)
{
	throw FError(MakeVertexDiagnostic(ESeverity::Error, ErrorVertexInput, Message), ExitUsage);
}

template<typename T>
T Read(const uint8* Bytes, int32 Index)
{
	T Value;
	std::memcpy(&Value, Bytes + size_t(Index) * sizeof(T), sizeof(T));
	return Value;
}

uint32 GetElementSize(EVertexElementType Type)
{
	const auto IsOneOf = [Type](std::initializer_list<EVertexElementType> Types)
	{
		return std::ranges::find(Types, Type) != Types.end();
	};
	return IsOneOf({VET_Float1, VET_PackedNormal, VET_UByte4, VET_UByte4N, VET_Color, VET_Short2, VET_Short2N,
			   VET_Half2, VET_UInt})
			   ? 4
		   : IsOneOf({VET_Float2, VET_Short4, VET_Half4}) ? 8
		   : Type == VET_Float3                           ? 12
		   : Type == VET_Float4                           ? 16
														  : 0;
}

/** Reads one element; components that are not there are (0, 0, 0, 1). */
void Decode(EVertexElementType Type, const uint8* Bytes, double (&Out)[4])
{
	Out[0] = Out[1] = Out[2] = 0;
	Out[3] = 1;
	const int32 NumFloats = Type == VET_Float1   ? 1
							: Type == VET_Float2 ? 2
							: Type == VET_Float3 ? 3
							: Type == VET_Float4 ? 4
												 : 0;
	for (int32 i = 0; i < NumFloats; ++i)
	{
		Out[i] = Read<float>(Bytes, i);
	}
	const int32 NumHalfs = Type == VET_Half2 ? 2 : Type == VET_Half4 ? 4 : 0;
	for (int32 i = 0; i < NumHalfs; ++i)
	{
		Out[i] = DecodeHalf(Read<uint16>(Bytes, i));
	}
	const int32 NumShorts = Type == VET_Short2 || Type == VET_Short2N ? 2 : Type == VET_Short4 ? 4 : 0;
	for (int32 i = 0; i < NumShorts; ++i)
	{
		const double Value = Read<int16>(Bytes, i);
		Out[i] = Type == VET_Short2N ? std::max(-1.0, Value / 32767) : Value;
	}
	for (int32 i = 0; i < 4; ++i)
	{
		constexpr int32 BlueFirst[4] = {2, 1, 0, 3}; // FColor lies as blue, green, red, alpha
		switch (Type)
		{
		case VET_UByte4:
			Out[i] = Bytes[i];
			break;
		case VET_UByte4N:
			Out[i] = Bytes[i] / 255.0;
			break;
		case VET_Color:
			Out[i] = Bytes[BlueFirst[i]] / 255.0;
			break;
		case VET_PackedNormal:
			Out[i] = std::max(-1.0, Read<int8>(Bytes, i) / 127.0);
			break;
		default:
			break;
		}
	}
	if (Type == VET_UInt)
	{
		Out[0] = Read<uint32>(Bytes, 0);
	}
}

} // namespace

FDiagnostic MakeVertexDiagnostic(ESeverity Severity, EVertexError Code, const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Severity = Severity;
	Diagnostic.Code = Code;
	Diagnostic.Message = Message;
	const FCodeOwner* const Running = GetRunningCode();
	if (Running && !Running->Pass.empty())
	{
		Diagnostic.Where = "pass " + Running->Pass;
		Diagnostic.File = Running->File;
		Diagnostic.Line = Running->Line;
	}
	return Diagnostic;
}

void SetShaderBinder(FShaderBinder Binder)
{
	GBinder = Binder;
}

void BindIfNothingIs(FBoundShader& Bound, const FRHIShader* Shader)
{
	const FShaderBinder Binder = GBinder;
	if (!Bound.IsValid() && Shader && Shader->GetPermutation() && Binder)
	{
		Bound = Binder(*Shader->GetPermutation());
	}
}

void RequireAllSet(const FBoundShader& Bound)
{
	if (!Bound.Unset.empty())
	{
		ThrowInput("shader " + Bound.Name + " reads '" + Bound.Unset.front() +
				   "', which nobody has set: set it after the pipeline state and before the draw or dispatch");
	}
}

void FVertexState::SetPipeline(const FGraphicsPipelineStateInitializer& Initializer)
{
	Shader = Initializer.BoundShaderState.VertexShaderRHI;
	Declaration = Initializer.BoundShaderState.VertexDeclarationRHI;
	PrimitiveType = Initializer.PrimitiveType;
	Bound = FBoundShader();
	bDrawsScreenRectangle = false;
}

void FVertexState::CheckAttribute(uint32 Attribute) const
{
	const std::string Reads = "vertex shader " + Bound.Name + " reads ATTRIBUTE" + std::to_string(Attribute) + ", ";
	if (!Declaration)
	{
		ThrowInput(Reads + "but the pipeline state has no vertex declaration: set "
						   "BoundShaderState.VertexDeclarationRHI (GFilterVertexDeclaration.VertexDeclarationRHI for "
						   "the rectangle of the screen)");
	}
	const FVertexElement* Found = nullptr;
	for (const FVertexElement& Element : Declaration->GetElements())
	{
		Found = Element.AttributeIndex == Attribute ? &Element : Found;
	}
	if (!Found || GetElementSize(Found->Type) == 0)
	{
		ThrowInput(Reads + "which the vertex declaration of the pipeline state does not have");
	}
	if (Found->StreamIndex >= MaxStreams || !Streams[Found->StreamIndex].Buffer)
	{
		ThrowInput(Reads + "but stream " + std::to_string(Found->StreamIndex) +
				   " has no buffer: call SetStreamSource before the draw");
	}
}

void FVertexState::CheckInput(const FVertexDraw& Draw) const
{
	if (Draw.bIndexed && !Draw.IndexBuffer)
	{
		ThrowInput("the index buffer of DrawIndexedPrimitive is null (vertex shader " + Bound.Name + ")");
	}
	for (const FShaderConstant& Constant : Bound.GetReflection().Constants)
	{
		const std::string& Buffer = Bound.GetReflection().ConstantBuffers[Constant.Buffer].Name;
		if (Constant.bUsed && Buffer == GDrawRectangleParametersName && !bDrawsScreenRectangle)
		{
			ThrowInput("vertex shader " + Bound.Name + " calls DrawRectangle of Common.ush" +
					   (Constant.Where.empty() ? "" : " (" + Constant.Where + ")") +
					   ", whose rectangle only DrawRectangle, DrawScreenPass and AddDrawScreenPass in C++ give it");
		}
	}
	for (uint32 Attribute = 0; Attribute < uint32(GMaxVertexAttributes); ++Attribute)
	{
		if (Bound.Vertex->GetAttributesRead() >> Attribute & 1)
		{
			CheckAttribute(Attribute);
		}
	}
}

void FVertexState::CheckTexCoords(const FBoundShader& Pixel) const
{
	const FShaderReflection& Read = Pixel.GetReflection();
	const uint32 Written = Bound.IsValid() ? Bound.Vertex->GetTexCoordsWritten() : (1u << GMaxTexCoords) - 1;
	const uint32 Integers = Bound.IsValid() ? Bound.GetReflection().IntegerInterpolants : 0;
	for (int32 Index = 0; Index < Read.NumInterpolants; ++Index)
	{
		const std::string Name = GetInterpolantName(Index, Read.NamedInterpolants);
		const bool bAsked = Index + 1 == Read.NumInterpolants || (Index >= GFirstNamedInterpolant && !Name.empty());
		const bool bInteger = Read.IntegerInterpolants >> Index & 1;
		const int32 Output = FindOutput(Read, Index);
		const uint32 Bit = Output < 0 ? 0 : 1u << Output;
		if ((bAsked && !(Written & Bit)) || (bInteger && !(Integers & Bit)))
		{
			throw FError(MakeVertexDiagnostic(ESeverity::Error, ErrorVertexToPixel,
							 "pixel shader " + Pixel.Name + " reads " + Name + (bInteger ? " as integers" : "") +
								 ", which vertex shader " + (Bound.IsValid() ? Bound.Name : "FScreenPassVS") +
								 " does not write"),
				ExitUsage);
		}
	}
}

int32 FVertexState::FindOutput(const FShaderReflection& Pixel, int32 Interpolant) const
{
	if (Interpolant < GFirstNamedInterpolant || !Bound.IsValid())
	{
		return Interpolant < GFirstNamedInterpolant ? Interpolant : -1;
	}
	const std::vector<std::string>& Written = Bound.GetReflection().NamedInterpolants;
	const auto Found = std::ranges::find(Written, GetInterpolantName(Interpolant, Pixel.NamedInterpolants));
	return Found == Written.end() ? -1 : GFirstNamedInterpolant + int32(Found - Written.begin());
}

FVertexInput FVertexState::Fetch(const FVertexDraw& Draw, uint32 VertexId, uint32 Instance) const
{
	FVertexInput Input;
	Input.VertexId = VertexId;
	Input.InstanceId = Instance;
	for (int32 i = 0; Declaration && i < Declaration->GetElements().Num(); ++i)
	{
		const FVertexElement& Element = Declaration->GetElements()[i];
		if (Element.AttributeIndex >= GMaxVertexAttributes || Element.StreamIndex >= MaxStreams)
		{
			continue;
		}
		const FStream& Stream = Streams[Element.StreamIndex];
		const int64 Row =
			Element.bUseInstanceIndex ? int64(Draw.FirstInstance) + Instance : int64(Draw.BaseVertex) + VertexId;
		const int64 At = int64(Stream.Offset) + Row * Element.Stride + Element.Offset;
		const uint32 Size = GetElementSize(Element.Type);
		double(&Value)[4] = Input.Attributes[Element.AttributeIndex];
		if (Size > 0 && Stream.Buffer && At >= 0 && At + Size <= int64(Stream.Buffer->GetSize()))
		{
			Decode(Element.Type, Stream.Buffer->GetData() + At, Value);
		}
	}
	return Input;
}

std::vector<uint32> FVertexState::GetVertexIds(const FVertexDraw& Draw) const
{
	const bool bStrip = PrimitiveType == PT_TriangleStrip;
	std::vector<uint32> Ids;
	for (uint32 Triangle = 0; Triangle < Draw.NumPrimitives; ++Triangle)
	{
		for (uint32 Corner = 0; Corner < 3; ++Corner)
		{
			const uint32 Index = bStrip ? Triangle + Corner : 3 * Triangle + Corner;
			if (!Draw.bIndexed)
			{
				Ids.push_back(Index);
				continue;
			}
			const uint32 Stride = Draw.IndexBuffer->GetStride() == 4 ? 4 : 2;
			const uint64 At = (uint64(Draw.FirstIndex) + Index) * Stride;
			uint32 Id = 0;
			if (At + Stride <= Draw.IndexBuffer->GetSize())
			{
				std::memcpy(&Id, Draw.IndexBuffer->GetData() + At, Stride);
			}
			Ids.push_back(Id);
		}
	}
	return Ids;
}

std::vector<FVertexOutput> FVertexState::RunVertices(
	const FVertexDraw& Draw, uint32 Instance, const FShaderReflection& Pixel) const
{
	const FKernelArgs Args = Bound.GetArgs();
	std::map<uint32, FVertexOutput> Known;
	std::vector<FVertexOutput> Outputs;
	for (const uint32 Id : GetVertexIds(Draw))
	{
		const auto [Found, bNew] = Known.try_emplace(Id);
		if (bNew)
		{
			const FVertexOutput Output = Bound.Vertex->Run(Args, Fetch(Draw, Id, Instance));
			std::copy(std::begin(Output.Position), std::end(Output.Position), Found->second.Position);
			for (int32 Index = 0; Index < Pixel.NumInterpolants; ++Index)
			{
				const int32 From = FindOutput(Pixel, Index);
				std::copy_n(Output.TexCoords[std::max(0, From)], From < 0 ? 0 : 4, Found->second.TexCoords[Index]);
			}
		}
		Outputs.push_back(Found->second);
	}
	return Outputs;
}

} // namespace Drydock
