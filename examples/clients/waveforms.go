// Two binaries from a running server, in Go:
//
//	go mod init waveforms && go get github.com/vmihailenco/msgpack/v5
//	go run waveforms.go http://127.0.0.1:8000
package main

import (
	"bytes"
	"encoding/binary"
	"fmt"
	"io"
	"log"
	"net/http"
	"os"

	"github.com/vmihailenco/msgpack/v5"
)

type array struct {
	Type  string `msgpack:"type"` // "<c16": little endian, real and imaginary part
	Shape []int  `msgpack:"shape"`
	Data  []byte `msgpack:"data"`
}

func main() {
	server := "http://127.0.0.1:8000"
	if len(os.Args) > 1 {
		server = os.Args[1]
	}
	question, _ := msgpack.Marshal(map[string]any{
		"parameters": map[string]any{
			"mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": []float64{600, 700}, "chi_1": 0.01, "chi_2": 0.0,
			"distance_mpc": 40.0, "inclination": 2.5, "total_mass": 2.76,
		},
		"grid": map[string]float64{"f_min": 20, "f_max": 2048, "delta_f": 0.25},
	})
	response, err := http.Post(server+"/v1/models/default/waveforms", "application/msgpack", bytes.NewReader(question))
	if err != nil {
		log.Fatal(err)
	}
	defer response.Body.Close()
	body, err := io.ReadAll(response.Body)
	if err != nil || response.StatusCode != http.StatusOK {
		log.Fatalf("%s %s", response.Status, body)
	}
	var answer struct {
		H array `msgpack:"h_plus"`
	}
	if err := msgpack.Unmarshal(body, &answer); err != nil {
		log.Fatal(err)
	}
	for row := 0; row < answer.H.Shape[0]; row++ {
		columns := answer.H.Shape[1]
		var value complex128
		binary.Read(bytes.NewReader(answer.H.Data[16*(row*columns+columns-1000):]), binary.LittleEndian, &value)
		fmt.Printf("%d %.17g %.17g\n", row, real(value), imag(value))
	}
}
