// A shader as text, its parameters by name, its output as numbers: runs compiled kernels and the interpreter over the
// same inputs.
#pragma once

#include "Diagnostics.h"
#include "InspectedShader.h"
#include "KernelLimits.h"
#include "LanesDispatch.h"
#include "ShaderCompiler.h"
#include "ShaderFrontEnd.h"
#include "SpirvGroup.h"
#include "SpirvInterpreter.h"
#include "SpirvQuads.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Drydock::Test
{

/** A float RGBA texture, or R32_UINT when bUint, with the readable margins that kernels rely on. Mips lie one behind
 * the other. */
class FTestTexture
{
public:
	FTestTexture() = default;
	FTestTexture(int32_t InSizeX, int32_t InSizeY, bool bInUint = false, int32_t InNumMips = 1)
		: SizeX(InSizeX)
		, SizeY(InSizeY)
		, bUint(bInUint)
		, Memory(FirstTexelOf(InNumMips) * 16 + 128, 0)
		, Mips(size_t(InNumMips))
	{
	}

	float* Texel(int32_t X, int32_t Y, int32_t Mip = 0)
	{
		const size_t Index = FirstTexelOf(Mip) + size_t(Y) * size_t(GetSize(SizeX, Mip)) + size_t(X);
		return reinterpret_cast<float*>(Memory.data() + 64) + Index * (bUint ? 1 : 4);
	}
	uint32_t& Uint(int32_t X, int32_t Y)
	{
		return reinterpret_cast<uint32_t*>(Memory.data() + 64)[size_t(Y) * size_t(SizeX) + size_t(X)];
	}

	FKernelTexture View()
	{
		for (int32_t Mip = 0; Mip < int32_t(Mips.size()); ++Mip)
		{
			const int32_t Pitch = GetSize(SizeX, Mip) * (bUint ? 4 : 16);
			Mips[size_t(Mip)] = {reinterpret_cast<uint8_t*>(Texel(0, 0, Mip)), GetSize(SizeX, Mip), GetSize(SizeY, Mip),
				1, Pitch, int64_t(Pitch) * GetSize(SizeY, Mip)};
		}
		return {Mips.data(), int32_t(Mips.size()), bUint ? ETexelStorage::R32_UINT : ETexelStorage::RGBA32_FLOAT, 0, 0};
	}

	static int32_t GetSize(int32_t Size, int32_t Mip) { return std::max(1, Size >> Mip); }

	int32_t SizeX = 0;
	int32_t SizeY = 0;

private:
	size_t FirstTexelOf(int32_t Mip) const
	{
		size_t Index = 0;
		for (int32_t i = 0; i < Mip; ++i)
		{
			Index += size_t(GetSize(SizeX, i)) * size_t(GetSize(SizeY, i));
		}
		return Index;
	}

	bool bUint = false;
	std::vector<uint8_t> Memory;
	std::vector<FKernelMip> Mips = std::vector<FKernelMip>(1);
};

class FShaderHarness
{
public:
	FShaderHarness(const std::string& Text, const std::string& EntryPoint, EShaderStage Stage)
	{
		Request.VirtualPath = "/Test/Shader.usf";
		Request.GeneratedFiles = {{Request.VirtualPath, Text}};
		Request.EntryPoint = EntryPoint;
		Request.Stage = Stage;
	}

	FShaderCompileRequest Request;
	std::map<std::string, std::vector<uint32_t>> Constants; // words of a constant, as they lie in its buffer
	std::map<std::string, FTestTexture> Textures;
	std::map<std::string, FKernelTexture> Views; // textures that are somebody else's
	std::map<std::string, std::vector<uint32_t>> Buffers;
	FKernelSampler Sampler = {
		EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0, {}};
	std::vector<FTestTexture> Targets;
	int32_t WaveSize = FLaneConfig().WaveSize;
	FKernelInterpolant Interpolants[GMaxInterpolants] = {};

	void SetFloats(const std::string& Name, const std::vector<float>& Values)
	{
		std::vector<uint32_t>& Words = Constants[Name];
		Words.resize(Values.size());
		std::memcpy(Words.data(), Values.data(), Values.size() * 4);
	}
	void SetFloatBuffer(const std::string& Name, const std::vector<float>& Values)
	{
		Buffers[Name].resize(Values.size());
		std::memcpy(Buffers[Name].data(), Values.data(), Values.size() * 4);
	}
	float BufferFloat(const std::string& Name, size_t Index)
	{
		float Value;
		std::memcpy(&Value, &Buffers.at(Name).at(Index), 4);
		return Value;
	}

	/** The compiled kernel over [0, X) x [0, Y) x [0, Z). */
	std::shared_ptr<const FCompiledShader> Run(int32_t Lanes, int32_t X, int32_t Y, int32_t Z = 1, bool bDouble = false)
	{
		Request.Lanes = {bDouble, Lanes, WaveSize};
		const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
		Bind(Shader->Reflection);
		Shader->Run(Args, {0, 0, 0, X, Y, Z});
		return Shader;
	}

	/** The interpreter over the same box; render targets are written where the pixel was not discarded. */
	void RunModel(int32_t X, int32_t Y, int32_t Z = 1)
	{
		FSpirvModule Module;
		const FSpirvReflection Reflection = Reflect(Module);
		Bind(Reflection.Reflection);
		FSpirvInterpreter Interpreter(Module, Reflection, uint32_t(WaveSize));
		if (Reflection.Reflection.bGroups)
		{
			const int32_t* const Size = Reflection.Reflection.GroupSize;
			for (int32_t i = 0; i < X / Size[0] * (Y / Size[1]) * (Z / Size[2]); ++i)
			{
				const int32_t Row = i / (X / Size[0]);
				Interpreter.RunGroup(Args, i % (X / Size[0]), Row % (Y / Size[1]), Row / (Y / Size[1]));
			}
			return;
		}
		for (int32_t z = 0; z < Z; ++z)
		{
			for (int32_t y = 0; y < Y; ++y)
			{
				for (int32_t x = 0; x < X; ++x)
				{
					const FInterpretedPixel Pixel = Interpreter.Run(Args, x, y, z);
					for (size_t t = 0; t < Targets.size() && !Pixel.bDiscarded; ++t)
					{
						std::memcpy(Targets[t].Texel(x, y), Pixel.Targets[t], 16);
					}
				}
			}
		}
	}

	/** The same by the shader with its functions and local variables, as it is looked into. */
	void RunInspected(int32_t X, int32_t Y, int32_t Z = 1, bool bDouble = false)
	{
		FInspectedShader& Shader = Inspect();
		if (Shader.HasGroups())
		{
			bDouble ? RunGroups<double>(Shader, X, Y, Z) : RunGroups<float>(Shader, X, Y, Z);
			return;
		}
		const auto RunAll = [&](auto& Thread)
		{
			for (int32_t i = 0; i < X * Y * Z; ++i)
			{
				const int32_t At[3] = {i % X, i / X % Y, i / X / Y};
				Thread.Run(Args, At, nullptr, 10'000'000);
				StoreTargets(Shader, Thread, At[0], At[1]);
			}
		};
		if (bDouble)
		{
			TSpirvThread<double> Thread(Shader.GetProgram(), Shader.GetSlots());
			RunAll(Thread);
			return;
		}
		TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
		RunAll(Thread);
	}

	/** Bound and ready to be looked into, without a kernel; GetArgs has what it reads. */
	FInspectedShader& Inspect()
	{
		FSpirvModule Module;
		Reflected = Reflect(Module).Reflection;
		Bind(Reflected);
		Inspected = std::make_shared<FInspectedShader>(Request, Reflected);
		return *Inspected;
	}
	const FKernelArgs& GetArgs() const { return Args; }
	const FShaderReflection& GetReflection() const { return Reflected; }

	FKernelCounters Counters = {};

private:
	/** What a kernel is made of, and what it is bound by. */
	FSpirvReflection Reflect(FSpirvModule& Module) const
	{
		const FShaderSource Source = FlattenShader(Request);
		Module = ReadSpirv(CompileToSpirv(Source, Request));
		if (Request.bQuads)
		{
			RunByQuads(Module);
		}
		return ReflectSpirv(Module, BuildSpirvStructure(Module), Source.Text);
	}

	template<typename Real>
	void RunGroups(const FInspectedShader& Shader, int32_t X, int32_t Y, int32_t Z)
	{
		const uint32_t* const Size = Shader.GetModule().LocalSize;
		TSpirvGroup<Real> Group(Shader.GetProgram(), Shader.GetOrder(), Shader.GetSlots(), Shader.GetWaveSize());
		const bool bQuads = Shader.GetModule().bQuads;
		const auto Count = [&Size](int32_t Threads, int Axis)
		{
			return (Threads + int32_t(Size[Axis]) - 1) / int32_t(Size[Axis]);
		};
		const int32_t Counts[3] = {Count(X, 0), Count(Y, 1), Count(Z, 2)};
		for (int32_t i = 0; i < Counts[0] * Counts[1] * Counts[2]; ++i)
		{
			const int32_t Id[3] = {i % Counts[0], i / Counts[0] % Counts[1], i / Counts[0] / Counts[1]};
			uint32_t Helpers = 0;
			for (int32_t k = 0; bQuads && k < 4; ++k)
			{
				Helpers |= uint32_t(Id[0] * 2 + k % 2 >= X || Id[1] * 2 + k / 2 >= Y) << k;
			}
			Group.SetHelpers(Helpers);
			Group.Run(Args, Id, 10'000'000);
			for (int32_t k = 0; bQuads && k < 4; ++k)
			{
				if (!(Helpers >> k & 1))
				{
					StoreTargets(Shader, Group.GetThread(uint32_t(k)), Id[0] * 2 + k % 2, Id[1] * 2 + k / 2);
				}
			}
		}
	}

	template<typename TThread>
	void StoreTargets(const FInspectedShader& Shader, const TThread& Thread, int32_t X, int32_t Y)
	{
		const FSpirvModule& Module = Shader.GetModule();
		for (size_t i = 0; i < Module.Variables.size() && !Thread.WasDiscarded(); ++i)
		{
			const FSpirvVariable& Variable = Module.Variables[i];
			const FSpirvMemory& Memory = Shader.GetProgram().Memory[i];
			for (uint32_t c = 0; Variable.Storage == Spirv::StorageOutput && c < Memory.Size && c < 4; ++c)
			{
				const float Number = float(Thread.GetReal(Memory.First + c));
				const uint32_t Bits = Module.GetScalarKind(Variable.Type, c) == ESpirvType::Float
										  ? std::bit_cast<uint32_t>(Number)
										  : Thread.GetBits(Memory.First + c);
				std::memcpy(&Targets.at(Variable.Location).Texel(X, Y)[c], &Bits, 4);
			}
		}
	}

	void Bind(const FShaderReflection& R)
	{
		ConstantMemory.clear();
		ConstantPointers.clear();
		for (const FShaderConstantBuffer& Buffer : R.ConstantBuffers)
		{
			ConstantMemory.emplace_back(Buffer.Size, uint8_t(0));
		}
		for (const FShaderConstant& Constant : R.Constants)
		{
			const auto Found = Constants.find(Constant.Name);
			if (Found != Constants.end())
			{
				std::memcpy(ConstantMemory[Constant.Buffer].data() + Constant.Offset, Found->second.data(),
					Found->second.size() * 4);
			}
		}
		for (const std::vector<uint8_t>& Memory : ConstantMemory)
		{
			ConstantPointers.push_back(Memory.data());
		}
		const auto BindTextures = [this](const std::vector<FShaderResource>& List, std::vector<FKernelTexture>& Bound)
		{
			Bound.clear();
			for (const FShaderResource& Resource : List)
			{
				const auto View = Views.find(Resource.Name);
				Bound.push_back(View != Views.end() ? View->second : Textures.at(Resource.Name).View());
			}
		};
		const auto BindBuffers = [this](const std::vector<FShaderResource>& List, std::vector<FKernelBuffer>& Views)
		{
			Views.clear();
			for (const FShaderResource& Resource : List)
			{
				std::vector<uint32_t>& Words = Buffers.at(Resource.Name);
				const bool bTyped = Resource.Dimension == EShaderDimension::TypedBuffer;
				const ETexelStorage Storage = Resource.Scalar != EShaderScalar::Float ? ETexelStorage::R32_UINT
											  : Resource.NumComponents == 4           ? ETexelStorage::RGBA32_FLOAT
																					  : ETexelStorage::R32_FLOAT;
				const uint32_t Stride = bTyped ? (Storage == ETexelStorage::RGBA32_FLOAT ? 16 : 4) : Resource.Stride;
				Views.push_back(
					{reinterpret_cast<uint8_t*>(Words.data()), uint32_t(Words.size() * 4), Stride, Storage});
			}
		};
		BindTextures(R.Textures, TextureViews);
		BindTextures(R.RWTextures, RWTextureViews);
		BindBuffers(R.Buffers, BufferViews);
		BindBuffers(R.RWBuffers, RWBufferViews);
		SamplerViews.assign(R.Samplers.size(), Sampler);
		TargetViews.clear();
		for (FTestTexture& Target : Targets)
		{
			FKernelTarget View{};
			View.Texture = Target.View();
			if (R.IntegerTargets >> TargetViews.size() & 1)
			{
				View.Texture.Storage = ETexelStorage::RGBA32_UINT;
			}
			View.WriteMask = 15;
			TargetViews.push_back(View);
		}
		Args = {ConstantPointers.data(), TextureViews.data(), RWTextureViews.data(), SamplerViews.data(),
			BufferViews.data(), RWBufferViews.data(), TargetViews.data(), Interpolants, int32_t(TargetViews.size()),
			&Counters, GetKernelLimits()};
	}

	FShaderReflection Reflected;
	std::shared_ptr<FInspectedShader> Inspected;
	FKernelArgs Args = {};
	std::vector<std::vector<uint8_t>> ConstantMemory;
	std::vector<const uint8_t*> ConstantPointers;
	std::vector<FKernelTexture> TextureViews;
	std::vector<FKernelTexture> RWTextureViews;
	std::vector<FKernelSampler> SamplerViews;
	std::vector<FKernelBuffer> BufferViews;
	std::vector<FKernelBuffer> RWBufferViews;
	std::vector<FKernelTarget> TargetViews;
};

/** Text of the error that f throws, all messages; empty when it throws none. */
template<typename F>
std::string ErrorOf(F f)
{
	try
	{
		f();
	}
	catch (const FError& Error)
	{
		return Error.what();
	}
	return {};
}

/** 4, 8 and 16 float lanes, as far as this CPU has them. */
inline std::vector<int32_t> GetLaneCounts()
{
	std::vector<int32_t> Result;
	for (const int32_t Lanes : {4, 8, 16})
	{
		if (Lanes <= GetWidestLanes(false))
		{
			Result.push_back(Lanes);
		}
	}
	return Result;
}

/** Equal bits, or both NaN. */
inline bool SameFloat(float A, float B)
{
	return std::memcmp(&A, &B, 4) == 0 || (A != A && B != B);
}

} // namespace Drydock::Test
